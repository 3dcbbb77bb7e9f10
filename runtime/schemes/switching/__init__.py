"""Times at which loads and prescribed motions jump or kink, so that steps end there."""
