"""Tests, on shelves that mirror the code; helpers in `support`."""
