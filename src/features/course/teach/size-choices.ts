import { sizeOn } from "../../../course/judge/sizes.ts";
import type { SizeDraft } from "../../../course/made/task-form.ts";
import type { TargetPart } from "../../../course/target-part.ts";
import { radius, rounded, toDiameter } from "../../../kernel/units.ts";
import { printFeatures } from "../../../view/drawing/print-features.ts";

/** Tolerance within which the part has an offered size, mm. */
const SIZE_TOLERANCE = 0.01;
/** Distance from a corner at which a face is measured, mm on the radius. */
const FACE_OFFSET = 0.3;
const MOST = 24;

/** The sizes of a part to choose from: its diameters in the middle of their length, and its faces. */
export function sizeChoices({ outside, bore, rings }: TargetPart): readonly SizeDraft[] {
  const offered = (kind: SizeDraft["kind"], at: number, nominal: number): SizeDraft[] => {
    const found = sizeOn(rings, kind, at);
    return found && Math.abs(found.value - nominal) < SIZE_TOLERANCE
      ? [{ kind, at: rounded(at), nominal: rounded(nominal), on: false, upper: "0.05", lower: "-0.05" }]
      : [];
  };
  const across = (kind: "diameter" | "bore", outline: TargetPart["outside"]) =>
    printFeatures(outline)
      .cylinders.filter(({ left, right }) => right > left)
      .flatMap(({ r, left, right }) => offered(kind, (left + right) / 2, toDiameter(radius(r))));
  const faces = printFeatures(outside).positions.flatMap((p) =>
    offered("face", rounded(toDiameter(radius(p.r - FACE_OFFSET))), p.z),
  );
  return [...across("diameter", outside), ...across("bore", bore), ...faces].slice(0, MOST);
}
