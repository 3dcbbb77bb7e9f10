"""Torque: about a marker's z-axis, with its opposite on another body if there is one."""

from __future__ import annotations

from typing import Annotated, Literal

from symgen.loads.load import Acting, Load, LoadEffect
from symgen.schema.fields import MarkerRef, Meaning, Quantity, Scope, about


class Torque(Load):
    """A torque [N m] about a marker's z-axis, counter-clockwise; its opposite acts at ``reaction`` if given."""

    type: Literal["torque"] = "torque"
    marker: Annotated[MarkerRef, about('marker about whose z-axis it acts, `"body.marker"`')]
    value: Annotated[Quantity, Meaning("torque", "N m", scope=Scope.MEASURES)]
    reaction: Annotated[MarkerRef | None, about("marker at which the opposite torque acts")] = None

    carries = "moment"
    directed = "acts about the z-axis of its marker"

    def effect(self, m: Acting) -> LoadEffect:
        """Power: the torque times the turning rate about that axis, relative to the body of the reaction."""
        value = m.value("value")
        if self.reaction is None:
            marker = m.marker(self.marker)
            axis = m.z(marker)
            moment = [value * component for component in axis]
            rate, row = m.dot(axis, m.spin(marker)), m.generalised((marker, (), moment))
            return LoadEffect(row, applied=value * rate, action=m.action(moment=moment), size=value)
        marker, reaction = m.pair(self.marker, self.reaction)
        axis = m.z(marker)
        moment = [value * component for component in axis]
        rate = m.dot(axis, m.spin(marker)) - m.dot(axis, m.spin(reaction))
        row = m.generalised((marker, (), moment), (reaction, (), [-component for component in moment]))
        return LoadEffect(row, applied=value * rate, action=m.action(moment=moment), size=value)
