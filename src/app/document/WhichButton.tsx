import { showWhich, type WhichRegion } from "../place/place.ts";

/** Asks which cycle makes a shape; for a contour section of the open work, if there is one. */
export function WhichButton({
  name,
  className,
  regionOf,
}: {
  readonly name: string;
  readonly className: string;
  readonly regionOf?: () => WhichRegion | null;
}) {
  return (
    <button type="button" className={className} onClick={() => showWhich(regionOf?.() ?? null)}>
      {name}
    </button>
  );
}
