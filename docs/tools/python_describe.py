"""Says as JSON what the package actio has: names, signatures, docstrings. For python_reference.mjs."""

import inspect
import json
import re

import actio


def type_name(annotation):
    """An annotation as a reader writes it: no module before a name, `X or None` for what is optional."""
    if annotation in (inspect.Parameter.empty, inspect.Signature.empty):
        return ""
    text = annotation if isinstance(annotation, str) else inspect.formatannotation(annotation)
    text = re.sub(r"ForwardRef\('([^']*)'\)", r"\1", text)
    text = re.sub(r"\bnumpy\.ndarray\[Any, numpy\.dtype\[\w*[^\]]*\]\]", "ndarray", text)
    text = re.sub(r"\b(?:\w+\.)+(\w+)", r"\1", text)
    text = re.sub(r"ndarray\[Any, dtype\[\w+\]\]", "ndarray", text)
    return alternatives(text.replace("NoneType", "None"))


def alternatives(text):
    """`A or B` in place of Union[A, B] and of Optional[A]."""
    found = re.fullmatch(r"(Union|Optional)\[(.*)\]", text)
    if not found:
        return text
    parts, depth = [""], 0
    for sign in found[2]:
        depth += (sign == "[") - (sign == "]")
        if sign == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += sign
    return " or ".join([part.strip() for part in parts] + ["None"] * (found[1] == "Optional"))


def call(function, bound):
    """Name, type and default of each argument, and what is returned; None where Python does not say."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return None
    arguments, keywords = [], False
    for name, parameter in list(signature.parameters.items())[1 if bound else 0 :]:
        if parameter.kind is parameter.VAR_POSITIONAL:
            keywords = True
            arguments.append({"name": f"*{name}", "type": type_name(parameter.annotation)})
            continue
        if parameter.kind is parameter.KEYWORD_ONLY and not keywords:
            keywords = True
            arguments.append({"name": "*", "type": ""})
        argument = {"name": name, "type": type_name(parameter.annotation)}
        if parameter.kind is parameter.VAR_KEYWORD:
            argument["name"] = f"**{name}"
        elif parameter.default is not parameter.empty:
            text = isinstance(parameter.default, str)
            argument["default"] = json.dumps(parameter.default) if text else repr(parameter.default)
        arguments.append(argument)
    return {"arguments": arguments, "returns": type_name(signature.return_annotation)}


def members(cls):
    """Public members of a class that it does not have from elsewhere; fields are told by the class itself."""
    found = []
    for name, value in vars(cls).items():
        if name.startswith("_"):
            continue
        if isinstance(value, property):
            returned = inspect.signature(value.fget).return_annotation
            kind, doc, how = "property", inspect.getdoc(value), {"returns": type_name(returned)}
        elif inspect.isfunction(value):
            kind, doc, how = "method", inspect.getdoc(value), call(value, True)
        elif inspect.ismemberdescriptor(value):
            kind, doc, how = "field", None, None
        else:
            continue
        found.append({"name": name, "kind": kind, "doc": doc, "call": how})
    return found


def described(name):
    value = getattr(actio, name)
    if inspect.isclass(value):
        error = issubclass(value, Exception)
        return {
            "name": name,
            "kind": "error" if error else "class",
            "doc": value.__doc__ and inspect.getdoc(value),
            "call": None if error else call(value, False),
            "bases": [base.__name__ for base in value.__bases__],
            "members": members(value),
        }
    if callable(value):
        how = call(value, False)
        return {"name": name, "kind": "function", "doc": inspect.getdoc(value), "call": how, "members": []}
    return {"name": name, "kind": "value", "doc": None, "call": None, "members": []}


names = [name for name in actio.__all__ if not name.startswith("__")]
print(json.dumps({"doc": inspect.getdoc(actio), "names": [described(name) for name in names]}))
