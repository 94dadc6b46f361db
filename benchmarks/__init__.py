"""Side-by-side timings with the peers named in the speed targets; run `python -m benchmarks`."""
