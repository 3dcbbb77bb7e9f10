"""`python -m symgen`."""

import sys

from symgen.cli import main

if __name__ == "__main__":
    sys.exit(main())
