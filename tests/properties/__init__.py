"""Property tests: whatever is put in is refused in one line, or works.

`make test` tries a few inputs, always the same; `make slow` many, other ones each time,
and tells how many of them were accepted.
"""
