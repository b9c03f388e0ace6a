"""What people and robots see, hear and attend to."""
