"""What the plane of one colour shows, in pixels of the raw picture that it was taken from."""

from dataclasses import replace

from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.core.observations import BlockObservation
from crenel.metrology.bayer import CELL_PX, BayerPlane


def raw_board(seen: BoardObservation, plane: BayerPlane) -> BoardObservation:
    """Corners and stripe of a board."""
    found = seen.detection
    detection = replace(
        found,
        uv_px=plane.raw_px(found.uv_px),
        covariance_px2=CELL_PX**2 * found.covariance_px2,
    )
    return replace(seen, detection=detection, stripe=plane.raw_stripe(seen.stripe))


def raw_block(
    seen: BlockObservation, plane: BayerPlane, size_px: tuple[int, int]
) -> BlockObservation:
    """Edges, corners, stripe and first camera of a block; ``size_px`` of the raw picture."""
    found = seen.detection
    edges = tuple(
        replace(edge, uv_px=plane.raw_px(edge.uv_px), sigma_px=CELL_PX * edge.sigma_px)
        for edge in found.edges
    )
    u, v = plane.offset_px
    corners = tuple(
        replace(
            corner,
            u=CELL_PX * corner.u + u,
            v=CELL_PX * corner.v + v,
            covariance_px2=CELL_PX**2 * corner.covariance_px2,
        )
        for corner in found.corners
    )
    detection = replace(
        found,
        corners=corners,
        edges=edges,
        camera=plane.raw_camera(found.camera, *size_px),
        rms_px=CELL_PX * found.rms_px,
    )
    return replace(seen, detection=detection, stripe=plane.raw_stripe(seen.stripe))
