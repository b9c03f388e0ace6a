"""Blocks of output are renewed by what the Python before them prints."""

from experiments.docs_tools.outputs import main, renewed

PAGE = """# A page

```python
x = 2
print(x)
```

Some words.

```output
{first}```

```python
print(x + 1)
print("done")
```

```output
{second}```

```text
pip install nothing
```
"""


def test_what_was_printed_takes_the_place_of_what_was_there():
    old = PAGE.format(first="7\n", second="")
    assert renewed(old) == PAGE.format(first="2\n", second="3\ndone\n")


def test_pages_without_output_stay_as_they_are():
    text = "```python\nprint(1)\n```\n\n```text\n2\n```\n"
    assert renewed(text) == text


def test_pages_are_renewed_in_place(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("```python\nprint(1)\n```\n```output\n```\n", "utf-8")
    main([page])
    assert page.read_text("utf-8") == "```python\nprint(1)\n```\n```output\n1\n```\n"
