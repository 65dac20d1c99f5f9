#!/usr/bin/env python3
"""break_lines.py FILE...: ends the lines of comments by column 110, which clang-format leaves alone.

What is short enough stays as it is: a paragraph is filled anew from its first long line on. Formulas, `code`
and references are not torn. In C++ a comment beside a long line moves above it, a long raw string becomes two,
and a body of one statement stands beside the head of its template, where clang-format 15 and later insist on
three lines.
What is left too long is printed, and the status is 1.
"""
import re
import sys

LIMIT = 110

# What begins a paragraph: a command, an item of a list, a row of a table, a formula on display, the mark of a
# snippet.
START = re.compile(
    r"^(?:[@\\](?!f[$\[]|ref\b|p\b|a\b|c\b|e\b|b\b|em\b|cite\b)"
    r"|[-*+] |\d+\. |\||```|#|\\f\[|\\f\]|\[\w+\]\s*$)")
ITEM = re.compile(r"^\s+\S+\s{2,}\S")
HEAD = re.compile(
    r"^([@\\](?:param(?:\[\w+\])?|tparam|throws|returns?|retval|note|pre|post|see|sa)"
    r"(?:\s+[A-Za-z_][\w:,.]*(?=\s\s)|\s+[A-Z]\w+(?=\s\s))?\s+)")
OPERATORS = {"=", "<", ">", "<=", ">=", "+", "-", "*", "/", "^", "+-", "->", r"\to"}


def words(text):
    """The words of a text: a formula or `code` is one where it is not too long, a reference has its name."""
    found = []
    for match in re.finditer(r"\S*?(?:\\f\$.*?\\f\$|`[^`]*`)\S*|\S+", text):
        found += match.group(0).split() if len(match.group(0)) > 70 else [match.group(0)]
    joined, glue = [], False
    for word in found:
        operator = word in OPERATORS
        if joined and (glue or operator) and len(joined[-1]) + len(word) < (60 if operator else 95):
            joined[-1] += " " + word
        else:
            joined.append(word)
        glue = operator or word.endswith((r"\ref", "@ref")) or word in (r"\cite", r"\p", r"\c", "@p")
    return joined


def leading(text):
    return text[: len(text) - len(text.lstrip())]


def hanging(text):
    """Where the further lines of a paragraph begin, if this is its only one."""
    stripped = text.strip()
    match = HEAD.match(stripped) or re.match(r"^((?:[-*+]|\d+\.) )", stripped)
    if not match and ITEM.match(text):
        match = re.match(r"^(\S+\s{2,})", stripped)
    return leading(text) + " " * min(len(match.group(1)) if match else 0, 24)


def fill(lead, paragraph):
    """The lines of a paragraph, filled anew from its first long one on."""
    first = next((i for i, text in enumerate(paragraph) if len(lead) + 1 + len(text) > LIMIT), None)
    if first is None:
        return paragraph
    hang = leading(paragraph[1]) if len(paragraph) > 1 else hanging(paragraph[0])
    lines, rest = paragraph[:first], words(" ".join(text.strip() for text in paragraph[first:]))
    if first == 0:
        # An item keeps the blanks before its text.
        text = paragraph[0].lstrip()
        head = re.match(r"^([@\\]\w+(?:\[\w+\])?(?:\s+\S+)?\s\s+|[@\\]\w+\s+|\S+\s{2,})", text)
        if head and (ITEM.match(paragraph[0]) or text[0] in "@\\"):
            further = " ".join(t.strip() for t in paragraph[1:])
            rest = [head.group(1)[:-1]] + words(text[head.end():] + " " + further)
    line = leading(paragraph[first]) if first == 0 else hang
    line += rest[0]
    for word in rest[1:]:
        if len(lead) + 1 + len(line) + 1 + len(word) <= LIMIT:
            line += " " + word
        else:
            lines.append(line)
            line = hang + word
    return lines + [line]


def fill_display(lead, text):
    """A formula on display, broken between its words."""
    lines, line = [], None
    for word in text.split():
        if line is None:
            line = leading(text) + word
        elif len(lead) + 1 + len(line) + 1 + len(word) <= LIMIT:
            line += " " + word
        else:
            lines.append(line)
            line = leading(text) + "  " + word
    return lines + [line]


def fill_block(lead, block):
    """The lines of consecutive comments of one indentation."""
    done, paragraph, code, display = [], [], False, False

    def flush():
        done.extend(fill(lead, paragraph) if paragraph else [])
        paragraph.clear()

    for text in block:
        stripped = text.strip()
        if code or stripped.startswith(("```", "@code", r"\code", "@verbatim", r"\verbatim")):
            flush()
            done.append(text)
            ends = stripped.startswith(("```", "@endcode", r"\endcode", "@endverbatim", r"\endverbatim"))
            code = not ends if code else True
        elif not stripped or stripped.startswith("|"):
            flush()
            done.append(text)
        elif display or stripped.startswith(r"\f["):
            flush()
            done += fill_display(lead, text) if len(lead) + 1 + len(text) > LIMIT else [text]
            display = r"\f]" not in text
        else:
            if START.match(stripped) or ITEM.match(text) or (
                    paragraph and text.startswith("    ") != paragraph[0].startswith("    ")
                    and not START.match(paragraph[0].strip())):
                flush()
            paragraph.append(text)
    flush()
    return [(lead + " " + text).rstrip() if text else lead for text in done]


def fill_comments(lines, mark):
    done, i = [], 0
    comment = re.compile(r"^(\s*)(" + mark + r")(?: (.*)|$)")
    while i < len(lines):
        match = comment.match(lines[i])
        if not match:
            done.append(lines[i])
            i += 1
            continue
        lead, block = match.group(1) + match.group(2), []
        while match and match.group(1) + match.group(2) == lead:
            block.append(match.group(3) or "")
            i += 1
            match = comment.match(lines[i]) if i < len(lines) else None
        done += fill_block(lead, block)
    return done


def comment_beside(line):
    """Where a comment beside code begins, outside of strings; -1 if there is none."""
    i, quote = 0, None
    while i < len(line):
        if quote:
            i += line[i] == "\\"
            quote = None if i < len(line) and line[i] == quote and line[i - 1] != "\\" else quote
        elif line[i] == '"' or (line[i] == "'" and not (i and line[i - 1].isalnum())):
            quote = line[i]
        elif line.startswith("//", i):
            return i
        i += 1
    return -1


def move_comments_above(lines):
    done = []
    for line in lines:
        at = comment_beside(line) if len(line) > LIMIT and 'R"' not in line else -1
        if at > 0 and line[:at].strip():
            mark, text = ("/// ", line[at + 4:]) if line.startswith("///<", at) else ("// ", line[at + 2:])
            done.append(leading(line) + mark + text.strip())
            line = line[:at].rstrip()
        done.append(line)
    return done


def split_raw_strings(lines):
    done = []
    for line in lines:
        while len(line) > LIMIT:
            # The string that passes the limit, not one beside it.
            strings = re.finditer(r'R"\(([^"]*?)\)"', line)
            match = next((m for m in strings if m.start(1) < LIMIT - 2 < m.end(1) + 2), None)
            begin = match.start(1) + 20 if match else LIMIT
            cut = max(line.rfind(" ", begin, LIMIT - 2) + 1, line.rfind("\\", begin, LIMIT - 2))
            if cut <= begin:
                break
            done.append(line[:cut] + ')"')
            pad = "" if line.lstrip().startswith('R"') else "    "
            line = leading(line) + pad + 'R"(' + line[cut:]
        done.append(line)
    return done


def join_short_bodies(lines):
    done, i = [], 0
    while i < len(lines):
        line = lines[i]
        if (i + 2 < len(lines) and done and line.endswith((") {", "const {", "noexcept {"))
                and re.match(r"\s*(template\b|requires\b)", done[-1]) and lines[i + 2] == leading(line) + "}"
                and leading(lines[i + 1]) == leading(line) + "  " and lines[i + 1].endswith(";")
                and not re.match(r"\s*(if|for|while|do|switch|//|template|requires)\b", line)
                and not re.match(r"\s*(if|for|while|//)", lines[i + 1])
                and len(joined := line + " " + lines[i + 1].strip() + " }") <= LIMIT):
            done.append(joined)
            i += 3
        else:
            done.append(line)
            i += 1
    return done


def main(files):
    left = 0
    for name in files:
        with open(name, encoding="utf-8") as file:
            before = file.read()
        lines = before.split("\n")
        if name.endswith((".hpp", ".cpp")):
            lines = split_raw_strings(join_short_bodies(fill_comments(move_comments_above(lines), "///?")))
        else:
            lines = fill_comments(lines, "//" if name.endswith((".mjs", ".js")) else "#")
        after = "\n".join(lines)
        if after != before:
            with open(name, "w", encoding="utf-8") as file:
                file.write(after)
        for number, line in enumerate(lines, 1):
            if len(line) > LIMIT:
                print(f"{name}:{number}: {len(line)} columns")
                left += 1
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
