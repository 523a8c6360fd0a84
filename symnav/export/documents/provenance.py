"""What a bundle was made from and what it holds: specification, licence, bill of materials."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping

from symnav import __version__
from symnav.emit.templates import render
from symnav.export.building import build_files
from symnav.export.records import Bundle

LICENCE = "0BSD"
"""Of what comes from symnav's templates; everything else is the user's."""

BILL = "sbom.spdx.json"

CREATED = "1970-01-01T00:00:00Z"
"""SPDX wants a time of creation; a clock would end the reproducibility of the bytes."""

_PACKAGE, _GENERATOR = "SPDXRef-Package", "SPDXRef-Generator"
_CODE = (".c", ".h")
_PROSE = (".md", ".csv")


def files(bundle: Bundle) -> Mapping[str, str]:
    """Licence and specification.

    ``spec.json`` is the canonical text that the digest in every file is taken over, ``spec.toml``
    the same as input of the generator, where an equation in Python does not rule that out.
    """
    module = bundle.trees[0].module
    text = {
        "LICENSE": render("export/docs/LICENSE.j2", generator=module.generator),
        "spec.json": bundle.spec.text,
        ".gitignore": "build/\n",
    }
    return text | ({"spec.toml": bundle.spec.toml} if bundle.spec.toml else {})


def bill(bundle: Bundle, text: Mapping[str, str]) -> Mapping[str, str]:
    """The bill of materials over the other files, as SPDX 2.3.

    Args:
        bundle: whose files they are.
        text: every file but the bill itself and the manifest, by path.
    """
    module = bundle.trees[0].module
    listed = [_file(path, text[path]) for path in sorted(text)]
    package = {
        "SPDXID": _PACKAGE,
        "name": bundle.name,
        "versionInfo": f"{build_files.version()}+{module.digest[:16]}",
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": True,
        "packageVerificationCode": {
            "packageVerificationCodeExcludedFiles": [f"./{BILL}", "./manifest.json"],
            "packageVerificationCodeValue": verification_code(text),
        },
        "licenseInfoFromFiles": [LICENCE],
        "licenseConcluded": LICENCE,
        "licenseDeclared": LICENCE,
        "copyrightText": "NOASSERTION",
        "summary": build_files.summary(bundle),
        "primaryPackagePurpose": "SOURCE",
    }
    generator = {
        "SPDXID": _GENERATOR,
        "name": "symnav",
        "versionInfo": __version__,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": "Apache-2.0",
        "licenseDeclared": "Apache-2.0",
        "copyrightText": "NOASSERTION",
        "primaryPackagePurpose": "APPLICATION",
    }
    fingerprint = _sum("sha256", _all(text))
    document = {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": bundle.name,
        "documentNamespace": f"https://spdx.org/spdxdocs/{bundle.name}-{fingerprint}",
        "creationInfo": {
            "created": CREATED,
            "creators": [f"Tool: symnav-{__version__}"],
            "comment": "The time is a constant: the same specification gives the same bytes.",
        },
        "packages": [package, generator],
        "files": listed,
        "relationships": _relationships(listed, bool(bundle.spec.toml)),
    }
    return {BILL: json.dumps(document, indent=2, ensure_ascii=False) + "\n"}


def verification_code(text: Mapping[str, str]) -> str:
    """SPDX's digest of a package: SHA-1 over the sorted SHA-1 digests of its files."""
    return _sum("sha1", "".join(sorted(_sum("sha1", content) for content in text.values())))


def _file(path: str, content: str) -> dict[str, object]:
    return {
        "SPDXID": _identifier(path),
        "fileName": f"./{path}",
        "fileTypes": [_kind(path)],
        "checksums": [
            {"algorithm": "SHA1", "checksumValue": _sum("sha1", content)},
            {"algorithm": "SHA256", "checksumValue": _sum("sha256", content)},
        ],
        "licenseConcluded": LICENCE,
        "licenseInfoInFiles": [LICENCE if path == "LICENSE" else "NOASSERTION"],
        "copyrightText": "NOASSERTION",
    }


def _kind(path: str) -> str:
    if path.endswith(_CODE):
        return "SOURCE"
    return "DOCUMENTATION" if path.endswith(_PROSE) else "TEXT"


def _relationships(listed: list[dict[str, object]], has_toml: bool) -> list[dict[str, str]]:
    specification = _identifier("spec.toml" if has_toml else "spec.json")
    triples = [
        ("SPDXRef-DOCUMENT", "DESCRIBES", _PACKAGE),
        (_PACKAGE, "GENERATED_FROM", specification),
        (_GENERATOR, "BUILD_TOOL_OF", _PACKAGE),
        *((_PACKAGE, "CONTAINS", str(one["SPDXID"])) for one in listed),
    ]
    return [
        {"spdxElementId": subject, "relationshipType": verb, "relatedSpdxElement": related}
        for subject, verb, related in triples
    ]


def _identifier(path: str) -> str:
    """An SPDX identifier, which knows letters, digits, points and hyphens alone."""
    return f"SPDXRef-{re.sub('[^A-Za-z0-9.-]', '-', path)}-{_sum('sha1', path)[:8]}"


def _all(text: Mapping[str, str]) -> str:
    return "".join(f"{path}\n{_sum('sha256', text[path])}\n" for path in sorted(text))


def _sum(algorithm: str, content: str) -> str:
    return hashlib.new(algorithm, content.encode(), usedforsecurity=False).hexdigest()
