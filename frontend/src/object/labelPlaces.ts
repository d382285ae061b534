export type Spot = readonly [number, number];

/** A label beside its spot: where its text begins, ends or has its middle, from the spot. */
export interface LabelPlace {
  dx: number;
  dy: number;
  anchor: "start" | "middle" | "end";
}

interface Room {
  /** Size of a label, in the unit of the spots. */
  wide: number;
  tall: number;
  /** Between a spot and its label; within it, a label covers a spot. */
  apart: number;
  /** Left, top, right and bottom, beyond which no label should be. */
  bounds?: readonly [number, number, number, number];
}

/** Sides of the spot, in the order of preference: beside it, above, below, then the corners. */
const SIDES = [
  [1, 0],
  [-1, 0],
  [0, -1],
  [0, 1],
  [1, -1],
  [-1, -1],
  [1, 1],
  [-1, 1],
] as const;
const ANCHORS = { "-1": "end", "0": "middle", "1": "start" } as const;
/** What is worse: a label that is cut off, one over another, or one over a spot. */
const COST = { cut: 100, label: 10, spot: 1 };

/** A place for the label of each of some spots, where it covers least of the other labels and of all spots. */
export function placeLabels(labelled: readonly Spot[], spots: readonly Spot[], room: Room): LabelPlace[] {
  const middles: Spot[] = [];
  return labelled.map(([x, y]) => {
    const costs = SIDES.map(([right, down]) => {
      const at = [x + right * (room.apart + room.wide / 2), y + down * (room.apart + room.tall / 2)] as const;
      const cost =
        COST.cut * Number(isCut(at, room)) +
        COST.label * middles.filter((other) => isNear(at, other, room.wide, room.tall)).length +
        COST.spot *
          spots.filter((spot) => isNear(at, spot, room.wide / 2 + room.apart / 2, room.tall / 2 + room.apart / 2))
            .length;
      return { at, cost, place: { dx: right * room.apart, dy: at[1] - y, anchor: ANCHORS[`${right}`] } };
    });
    const best = costs.reduce((one, other) => (other.cost < one.cost ? other : one));
    middles.push(best.at);
    return best.place;
  });
}

function isNear([x, y]: Spot, [u, v]: Spot, wide: number, tall: number): boolean {
  return Math.abs(x - u) < wide && Math.abs(y - v) < tall;
}

function isCut([x, y]: Spot, { wide, tall, bounds }: Room): boolean {
  if (!bounds) return false;
  const [left, top, right, bottom] = bounds;
  return x - wide / 2 < left || y - tall / 2 < top || x + wide / 2 > right || y + tall / 2 > bottom;
}
