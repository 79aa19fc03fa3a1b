"""What tools make of plans that were damaged in known ways."""
