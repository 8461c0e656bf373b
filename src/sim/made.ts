import type { Ring } from "../kernel/geometry/point.ts";
import type { Simulation } from "./simulation.ts";

/**
 * What a program has made by its end: what is still held, and the parts that it has cut off from the blank that is in
 * the chuck.
 */
export function madeOf({
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
