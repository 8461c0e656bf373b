import type { Ring } from "../kernel/geometry/point.ts";
import type { Simulation } from "./simulation.ts";

/** The parts produced by a program: the piece still held, and the parts cut off from the present blank. */
export function producedParts({
  final,
  checkpoints,
  proof,
}: Pick<Simulation, "final" | "checkpoints" | "proof">): readonly Ring[] {
  const stated = checkpoints.findLast((mark) => mark.isStated)?.step ?? 0;
  return [
    ...final,
    ...proof.loose.filter(({ shape, step }) => shape === "piece" && step > stated).flatMap(({ rings }) => rings),
  ];
}
