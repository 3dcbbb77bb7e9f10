"""C that is the same in every FMU: `core.c`, and the functions of either version of the standard."""
