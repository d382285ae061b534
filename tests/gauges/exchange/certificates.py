"""Digital Calibration Certificates of a sphere, composed for tests."""

HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<dcc:digitalCalibrationCertificate xmlns:dcc="https://ptb.de/dcc" xmlns:si="https://ptb.de/si"
  schemaVersion="{version}">
 <dcc:administrativeData>
  <dcc:coreData>
   <dcc:uniqueIdentifier>4711-2026</dcc:uniqueIdentifier>
   <dcc:endPerformanceDate>2026-03-12</dcc:endPerformanceDate>
  </dcc:coreData>
  <dcc:items><dcc:item>
   <dcc:name><dcc:content lang="de">Keramikkugel</dcc:content>
    <dcc:content lang="en">Ceramic sphere</dcc:content></dcc:name>
   <dcc:identifications>
    <dcc:identification><dcc:issuer>customer</dcc:issuer><dcc:value>PM-3</dcc:value>
    </dcc:identification>
    <dcc:identification><dcc:issuer>manufacturer</dcc:issuer><dcc:value>K-17</dcc:value>
    </dcc:identification>
   </dcc:identifications>
  </dcc:item></dcc:items>
  <dcc:calibrationLaboratory><dcc:contact><dcc:name><dcc:content>Lab A</dcc:content></dcc:name>
  </dcc:contact></dcc:calibrationLaboratory>
  <dcc:statements><dcc:statement refType="basic_recalibration">
   <dcc:date>2028-03-12</dcc:date></dcc:statement></dcc:statements>
 </dcc:administrativeData>
 <dcc:measurementResults><dcc:measurementResult>
  <dcc:influenceConditions><dcc:influenceCondition><dcc:data>
   <dcc:quantity><dcc:name><dcc:content>Diameter of the stylus</dcc:content></dcc:name>
    <si:real><si:value>3</si:value><si:unit>\\milli\\metre</si:unit></si:real></dcc:quantity>
  </dcc:data></dcc:influenceCondition></dcc:influenceConditions>
  <dcc:results><dcc:result><dcc:data>
"""
TAIL = """
  </dcc:data></dcc:result></dcc:results>
 </dcc:measurementResult></dcc:measurementResults>
</dcc:digitalCalibrationCertificate>
"""


def quantity(name: str, inner: str, kind: str = "") -> str:
    """One ``dcc:quantity`` with a name and a value."""
    reference = f' refType="{kind}"' if kind else ""
    return (
        f"<dcc:quantity{reference}><dcc:name><dcc:content>{name}</dcc:content></dcc:name>"
        f"{inner}</dcc:quantity>"
    )


def si(path: str, *inner: str) -> str:
    """Elements of D-SI within each other, by their names, and what is within the last."""
    text = "".join(inner)
    for name in reversed(path.split("/")):
        text = f"<si:{name}>{text}</si:{name}>"
    return text


def real(value: str, unit: str, uncertainty: str = "") -> str:
    return si("real", si("value", value), si("unit", unit), uncertainty)


def real_list(values: str, units: str, expanded_uncertainties: str) -> str:
    uncertainties = si("uncertaintyXMLList", expanded_uncertainties)
    known = si("expandedUncXMLList", uncertainties, si("coverageFactorXMLList", "2"))
    return si("realListXMLList", si("valueXMLList", values), si("unitXMLList", units), known)


def expanded(value: str, factor: str = "2") -> str:
    """As D-SI 1 has it."""
    return si("expandedUnc", si("uncertainty", value), si("coverageFactor", factor))


def expanded_mu(value: str, factor: str = "2") -> str:
    """As D-SI 2 has it."""
    known = (si("valueExpandedMU", value), si("coverageFactor", factor))
    return si("measurementUncertaintyUnivariate/expandedMU", *known)


def standard_mu(value: str) -> str:
    """As D-SI 2 has it."""
    return si("measurementUncertaintyUnivariate/standardMU/valueStandardMU", value)


def coverage_interval(value: str) -> str:
    """As D-SI 1 has it."""
    interval = si("intervalMin", "24.9") + si("intervalMax", "25.1")
    known = (si("standardUnc", value), interval, si("coverageProbability", "0.95"))
    return si("coverageInterval", *known)


def certificate(*quantities: str, version: str = "3.3.0") -> str:
    return HEAD.format(version=version) + "\n".join(quantities) + TAIL


DIAMETER = quantity("Diameter", real("25.0012", "\\milli\\metre", expanded("0.0006")))
FORM = quantity("Roundness", real("0.08", "\\micro\\metre", expanded("0.05")))
