"""The robustness study: engines held against exact arrangements. docs/study.md has the method."""
