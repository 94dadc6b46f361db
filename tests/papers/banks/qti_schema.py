"""What QTI 2.1.1, its content packages and MathML 2 allow of what is written here, from their schemas.

The schemas may not be copied into the project, so this says what they say of the elements that are used: the order of
children, attributes that must and that may be there, their values, where text may stand, what is declared where it is
named.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass

QTI = "{http://www.imsglobal.org/xsd/imsqti_v2p1}"
CP = "{http://www.imsglobal.org/xsd/imscp_v1p1}"
MATH = "{http://www.w3.org/1998/Math/MathML}"
XSI = "{http://www.w3.org/2001/XMLSchema-instance}"
XML = "{http://www.w3.org/XML/1998/namespace}"
NAME = r"(?a:[A-Za-z_][\w.-]*)"
NUMBER = r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?"

INTERACTIVE = "textEntryInteraction|inlineChoiceInteraction"
INLINE = "a|abbr|b|br|code|em|i|img|math|small|span|strong|sub|sup"
BLOCKS = "blockquote|div|dl|h1|h2|h3|h4|h5|h6|hr|math|ol|p|pre|table|ul"
BODY = f"(?:(?:{BLOCKS}|rubricBlock|choiceInteraction|extendedTextInteraction) )*"
FLOW = f"(?:(?:{INLINE}|{BLOCKS}|{INTERACTIVE}) )*"
LINE = f"(?:(?:{INLINE}|{INTERACTIVE}) )*"
CONDITION = "(?:equal|match|and) "
EXPRESSION = "(?:variable|correct|baseValue|sum|multiple|testVariables) "
RULE = "(?:responseCondition|setOutcomeValue) "


@dataclass(frozen=True)
class Model:
    """The children in order as a regular expression over "name name ", the attributes, whether text may stand in it."""

    children: str = ""
    required: str = ""
    optional: str = ""
    mixed: bool = False


COMMON = "id class xml:lang label"
TEXT = Model(mixed=True)
QTI_MODELS = {
    "assessmentItem": Model(
        "(responseDeclaration )*(outcomeDeclaration )*(itemBody )?(responseProcessing )?(modalFeedback )*",
        "identifier title adaptive timeDependent", "label xml:lang toolName toolVersion xsi:schemaLocation"),
    "responseDeclaration": Model("(correctResponse )?", "identifier cardinality", "baseType"),
    "outcomeDeclaration": Model("(defaultValue )?", "identifier cardinality",
                                "baseType view interpretation normalMaximum normalMinimum masteryValue"),
    "correctResponse": Model("(value )+"),
    "defaultValue": Model("(value )+"),
    "value": Model(optional="fieldIdentifier baseType", mixed=True),
    "itemBody": Model(BODY, optional=COMMON),
    "rubricBlock": Model(FLOW, "view", f"use {COMMON}", mixed=True),
    "modalFeedback": Model(FLOW, "outcomeIdentifier identifier showHide", "title", mixed=True),
    "div": Model(FLOW, optional=COMMON, mixed=True),
    "blockquote": Model(f"(?:(?:{BLOCKS}) )*", optional=f"cite {COMMON}"),
    **{name: Model(LINE, optional=COMMON, mixed=True)
       for name in "p h1 h2 h3 h4 h5 h6 pre b code em i small span strong sub sup".split()},
    "a": Model(LINE, "href", f"type {COMMON}", mixed=True),
    "br": Model(optional=COMMON),
    "hr": Model(optional=COMMON),
    "img": Model("", "src alt", f"longdesc height width {COMMON}"),
    "ol": Model("(li )*", optional=COMMON),
    "ul": Model("(li )*", optional=COMMON),
    "li": Model(FLOW, optional=COMMON, mixed=True),
    "table": Model("(caption )?(thead )?(tfoot )?(tbody )+", optional=f"summary {COMMON}"),
    "thead": Model("(tr )+", optional=COMMON),
    "tbody": Model("(tr )+", optional=COMMON),
    "tr": Model("((td|th) )+", optional=COMMON),
    **{name: Model(FLOW, optional=f"headers scope abbr axis rowspan colspan {COMMON}", mixed=True)
       for name in ("td", "th")},
    "textEntryInteraction": Model("", "responseIdentifier",
                                  f"base stringIdentifier expectedLength patternMask placeholderText {COMMON}"),
    "extendedTextInteraction": Model("(prompt )?", "responseIdentifier",
                                     f"base maxStrings minStrings expectedLines expectedLength format {COMMON}"),
    "inlineChoiceInteraction": Model("(inlineChoice )+", "responseIdentifier", f"shuffle required {COMMON}"),
    "inlineChoice": Model("", "identifier", f"fixed showHide {COMMON}", mixed=True),
    "choiceInteraction": Model("(prompt )?(simpleChoice )+", "responseIdentifier",
                               f"shuffle maxChoices minChoices orientation {COMMON}"),
    "prompt": Model(f"(?:(?:{INLINE}) )*", optional=COMMON, mixed=True),
    "simpleChoice": Model(FLOW, "identifier", f"fixed showHide {COMMON}", mixed=True),
    "responseProcessing": Model(f"(?:{RULE})*", optional="template templateLocation"),
    "responseCondition": Model("responseIf (responseElseIf )*(responseElse )?"),
    "responseIf": Model(f"{CONDITION}(?:{RULE})*"),
    "responseElseIf": Model(f"{CONDITION}(?:{RULE})*"),
    "setOutcomeValue": Model(EXPRESSION, "identifier"),
    "equal": Model(f"(?:{EXPRESSION}){{2}}", "toleranceMode", "tolerance includeLowerBound includeUpperBound"),
    "match": Model(f"(?:{EXPRESSION}){{2}}"),
    "and": Model(f"(?:{CONDITION})+"),
    "sum": Model(f"(?:{EXPRESSION})+"),
    "multiple": Model(f"(?:{EXPRESSION})*"),
    "variable": Model("", "identifier", "weightIdentifier"),
    "correct": Model("", "identifier"),
    "baseValue": Model("", "baseType", mixed=True),
    "testVariables": Model("", "variableIdentifier", "sectionIdentifier baseType weightIdentifier"),
    "assessmentTest": Model("(outcomeDeclaration )*(timeLimits )?(stylesheet )*(testPart )+(outcomeProcessing )?",
                            "identifier title", "toolName toolVersion xsi:schemaLocation"),
    "testPart": Model("(itemSessionControl )?(timeLimits )?(assessmentSection )+",
                      "identifier navigationMode submissionMode"),
    "itemSessionControl": Model(optional="maxAttempts showFeedback allowReview showSolution allowComment"),
    "assessmentSection": Model("(itemSessionControl )?(timeLimits )?(selection )?(ordering )?(rubricBlock )*"
                               "((assessmentItemRef|assessmentSection) )*",
                               "identifier title visible", "required fixed keepTogether"),
    "selection": Model("", "select", "withReplacement"),
    "assessmentItemRef": Model("", "identifier href", "required fixed category"),
    "outcomeProcessing": Model("(setOutcomeValue )*"),
}  # fmt: skip
CP_MODELS = {
    "manifest": Model("(metadata )?organizations resources ", "identifier", "version xsi:schemaLocation"),
    "metadata": Model("(schema )?(schemaversion )?"),
    "schema": TEXT,
    "schemaversion": TEXT,
    "organizations": Model("(organization )*", optional="default"),
    "resources": Model("(resource )*"),
    "resource": Model("(metadata )?(file )*(dependency )*", "identifier type", "href"),
    "file": Model("(metadata )?", "href"),
    "dependency": Model("", "identifierref"),
}

PRESENTATION = "mi|mn|mo|mtext|mspace|mrow|mfrac|msqrt|mroot|mstyle|msub|msup|msubsup|munder|mover|munderover|mtable"
ANY = f"(?:(?:{PRESENTATION}) )*"
EVERY = "class style id"
MATH_MODELS = {
    "math": Model(ANY, optional=f"display alttext {EVERY}"),
    **{name: Model(optional=f"mathvariant {EVERY}", mixed=True) for name in ("mi", "mn", "mtext")},
    "mo": Model(optional=f"mathvariant form fence separator lspace rspace stretchy symmetric maxsize minsize largeop "
                f"movablelimits accent {EVERY}", mixed=True),
    "mspace": Model(optional=f"width height depth linebreak {EVERY}"),
    **{name: Model(ANY, optional=EVERY) for name in ("mrow", "msqrt")},
    "mstyle": Model(ANY, optional=f"displaystyle scriptlevel {EVERY}"),
    **{name: Model(f"(?:(?:{PRESENTATION}) ){{{count}}}", optional=f"{more} {EVERY}") for name, count, more in (
        ("mfrac", 2, "linethickness"), ("mroot", 2, ""), ("msub", 2, ""), ("msup", 2, ""), ("msubsup", 3, ""),
        ("munder", 2, "accentunder"), ("mover", 2, "accent"), ("munderover", 3, "accent accentunder"))},
    "mtable": Model("(mtr )*", optional=f"displaystyle columnalign rowspacing columnspacing {EVERY}"),
    "mtr": Model("(mtd )*", optional=f"columnalign {EVERY}"),
    "mtd": Model(ANY, optional=f"columnalign rowspan columnspan {EVERY}"),
}  # fmt: skip
MODELS = {f"{space}{name}": model for space, models in ((QTI, QTI_MODELS), (CP, CP_MODELS), (MATH, MATH_MODELS))
          for name, model in models.items()}  # fmt: skip

VALUES = {
    **dict.fromkeys("identifier responseIdentifier outcomeIdentifier variableIdentifier identifierref".split(), NAME),
    **dict.fromkeys("adaptive timeDependent visible keepTogether shuffle showFeedback allowReview fence separator "
                    "stretchy symmetric largeop movablelimits accent accentunder displaystyle".split(), "true|false"),
    **dict.fromkeys("expectedLength expectedLines maxChoices maxAttempts select rowspan colspan columnspan".split(),
                    r"\d+"),
    "normalMaximum": NUMBER, "tolerance": f"{NUMBER} {NUMBER}", "toleranceMode": "exact|absolute|relative",
    "baseType": "float|identifier|string", "cardinality": "single|multiple", "showHide": "show|hide", "view": "scorer",
    "navigationMode": "linear|nonlinear", "submissionMode": "individual|simultaneous", "label": ".{1,256}",
    "type": "imsqti_(?:item|test)_xmlv2p1", "display": "block|inline", "form": "prefix|infix|postfix",
}  # fmt: skip
"""The values of attributes: those of the schemas, of their types only those that are used."""

TEXTS = {f"{CP}schema": "QTIv2.1 Package", f"{CP}schemaversion": "1.0.0"}

STATIC = ("modalFeedback", "rubricBlock", "prompt", "simpleChoice")
"""No answer can be given in these."""


def faults(root):
    """Return what a document of QTI, or a manifest, has that its schema does not allow, in words."""
    found = [fault for element in root.iter() for fault in _faults(element)]
    for place in STATIC:
        for element in root.iter(f"{QTI}{place}"):
            found += [f"an interaction in {place}" for each in element.iter() if each.tag.endswith("Interaction")]
    return found + (_names(root) if root.tag == f"{QTI}assessmentItem" else [])


def _faults(element):
    model = MODELS.get(element.tag)
    if model is None:
        return [f"{element.tag} is not known"]
    found = []
    children = "".join(f"{each.tag.rpartition('}')[2]} " for each in element)
    name = element.tag.rpartition("}")[2]
    if not re.fullmatch(model.children, children):
        found.append(f"in {name}: {children}")
    spelled = {each.replace(XML, "xml:").replace(XSI, "xsi:") for each in element.attrib}
    required, optional = set(model.required.split()), set(model.optional.split())
    found += [f"{name} has no {each}" for each in required - spelled]
    found += [f"{name} has {each}" for each in spelled - required - optional]
    found += [f"{name} has {each}={value}" for each, value in element.attrib.items()
              if not re.fullmatch(VALUES.get(each, "(?s:.*)"), value)]  # fmt: skip
    if element.text != TEXTS.get(element.tag, element.text):
        found.append(f"{name} is {element.text}")
    texts = [element.text, *(each.tail for each in element)]
    if not model.mixed and any(text and text.strip() for text in texts):
        found.append(f"text in {name}")
    return found


def _names(item):
    """Return what is named and not declared, declared twice, or no name."""
    declared = {each.get("identifier"): each for each in item.iter(f"{QTI}responseDeclaration")}
    outcomes = {each.get("identifier"): each for each in item.iter(f"{QTI}outcomeDeclaration")}
    counted = Counter(each.get("identifier") for each in item if each.tag.endswith("Declaration"))
    found = [f"{name} is declared {times} times" for name, times in counted.items() if times > 1]
    asked = Counter(each.get("responseIdentifier") for each in item.iter() if each.tag.endswith("Interaction"))
    found += [f"{name} is asked {times} times" for name, times in asked.items() if times > 1]
    found += [f"{name} is asked or declared, not both" for name in set(asked) ^ set(declared)]
    used = {each.get("identifier") for tag in ("variable", "correct") for each in item.iter(f"{QTI}{tag}")}
    found += [f"{name} is used, not declared" for name in used - set(declared) - set(outcomes)]
    set_to: dict[str, set[str]] = {}
    for rule in item.iter(f"{QTI}setOutcomeValue"):
        values = {each.text for each in rule.iter(f"{QTI}baseValue")}
        set_to.setdefault(rule.get("identifier"), set()).update(values)
    found += [f"{name} is set, not declared" for name in set(set_to) - set(outcomes)]
    told = {(each.get("outcomeIdentifier"), each.get("identifier")) for each in item.iter(f"{QTI}modalFeedback")}
    found += [f"{value} of {name} is never set" for name, value in told if value not in set_to.get(name, ())]
    return found + [
        f"nothing is told for {value}" for value in set_to.get("FEEDBACK", ()) if ("FEEDBACK", value) not in told
    ]
