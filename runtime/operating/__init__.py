"""States at which a model rests or turns steadily, and the linear systems about them."""
