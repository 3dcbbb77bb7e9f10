"""What every benchmark uses: times that can be compared, results, the page, the machine."""
