/** A drawing scale: so many millimetres on paper stand for so many of the part. */
export interface DrawingScale {
  readonly paper: number;
  readonly part: number;
}

/** The scales of drawings as ISO 5455 has them, the largest picture first. */
export const DRAWING_SCALES: readonly DrawingScale[] = [
  ...[50, 20, 10, 5, 2, 1].map((paper) => ({ paper, part: 1 })),
  ...[2, 5, 10, 20, 50, 100, 200, 500, 1000].map((part) => ({ paper: 1, part })),
];

const SMALLEST: DrawingScale = { paper: 1, part: 1000 };

export const factorOf = ({ paper, part }: DrawingScale): number => paper / part;

interface Extent {
  readonly wide: number;
  readonly tall: number;
}

/** The largest of the usual scales at which a thing fits, all mm; the smallest of them if it fits at none. */
export function usualScale(thing: Extent, room: Extent): DrawingScale {
  const fits = (scale: DrawingScale) =>
    thing.wide * factorOf(scale) <= room.wide && thing.tall * factorOf(scale) <= room.tall;
  return DRAWING_SCALES.find(fits) ?? SMALLEST;
}

/** The scale at which a thing fills its room, at least the largest usual one: for a screen, where nothing is measured. */
export function fillingScale(thing: Extent, room: Extent): DrawingScale {
  const usual = usualScale(thing, room);
  const filling = Math.min(room.wide / thing.wide, room.tall / thing.tall);
  return filling > factorOf(usual) && Number.isFinite(filling) ? { paper: filling, part: 1 } : usual;
}
