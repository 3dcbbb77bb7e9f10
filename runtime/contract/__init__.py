"""What both halves share: names, shapes and formats of an emitted model, and how it is loaded."""
