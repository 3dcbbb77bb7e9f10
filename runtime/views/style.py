"""The colours that pictures, films and pages share."""

# of Okabe and Ito, told apart with every usual kind of colour vision; black is kept for totals
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#6a4c93")
