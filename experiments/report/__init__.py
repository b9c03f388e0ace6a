"""What people read of the results: the report, the tables in the terminal."""
