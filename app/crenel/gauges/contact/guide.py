"""The contact test: what is said, shown and asked in its steps. Pure."""

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar

from crenel.findings import Finding
from crenel.gauges.contact.guide_picture import (
    contact_findings,
    contact_instruction,
    contact_number,
    contact_picture,
    contact_title,
)
from crenel.gauges.contact.guide_sequence import group_of
from crenel.gauges.contact.guide_state import ContactState
from crenel.gauges.guide_live import PerformanceLive
from crenel.gauges.guide_view import PerformancePicture
from crenel.gauges.session.entries import AnyScan
from crenel.gauges.session.kind import PerformanceKind
from crenel.guide.common.view import LiveNumber
from crenel.messages.message import Text, message


class ContactKind(PerformanceKind[ContactState, AnyScan]):
    """The contact test."""

    titles: ClassVar[Mapping[str, Text]] = {
        "diameter": message("performance-step-diameter"),
        "seats": message("performance-step-seats"),
        "bar": message("performance-step-bar"),
    }

    def title(self, state: ContactState) -> Text:
        if not state.feature:
            return ""
        return contact_title(state.step, group_of(state.step, len(state.of_step)) + 1)

    def instruction(self, state: ContactState, live: PerformanceLive) -> Text:
        return contact_instruction(state)

    def number(self, state: ContactState, live: PerformanceLive) -> LiveNumber | None:
        return contact_number(state, live.contact)

    def draw(
        self, picture: PerformancePicture, state: ContactState, live: PerformanceLive
    ) -> PerformancePicture:
        if live.contact is None or state.step not in state.between:
            return picture
        return replace(picture, contact=contact_picture(state, live.contact))

    def findings(self, state: ContactState, live: PerformanceLive) -> list[Finding]:
        return contact_findings(state, live.contact)
