"""Pictures of homes and of the people in them."""
