"""The symbol tables: names of the code, symbols of the paper."""
