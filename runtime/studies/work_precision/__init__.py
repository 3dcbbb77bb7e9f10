"""Methods compared on one problem: error against CPU time, with an independent reference."""
