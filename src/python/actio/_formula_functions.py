"""The functions of a formula."""

#: Each with its name in NumPy and the number of its arguments.
FUNCTIONS = {
    "sin": ("sin", 1),
    "cos": ("cos", 1),
    "tan": ("tan", 1),
    "asin": ("arcsin", 1),
    "acos": ("arccos", 1),
    "atan": ("arctan", 1),
    "atan2": ("arctan2", 2),
    "sinh": ("sinh", 1),
    "cosh": ("cosh", 1),
    "tanh": ("tanh", 1),
    "asinh": ("arcsinh", 1),
    "acosh": ("arccosh", 1),
    "atanh": ("arctanh", 1),
    "exp": ("exp", 1),
    "log": ("log", 1),
    "log2": ("log2", 1),
    "log10": ("log10", 1),
    "sqrt": ("sqrt", 1),
    "cbrt": ("cbrt", 1),
    "hypot": ("hypot", 2),
}

#: Those with kinks or jumps, of formulas that are not differentiated.
KINKED = {
    "abs": ("absolute", 1),
    "sign": ("sign", 1),
    "floor": ("floor", 1),
    "ceil": ("ceil", 1),
    "min": ("minimum", 2),
    "max": ("maximum", 2),
}
