"""Tests, on shelves that mirror the code; helpers in `support`.

Linear algebra takes one thread: the processes of a run of tests share the processors already.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
