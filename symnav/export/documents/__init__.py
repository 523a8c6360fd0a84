"""What people read in a bundle, and what it was made from."""
