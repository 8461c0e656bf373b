import type { Move } from "../kernel/plan/move.ts";
import { radius, toDiameter } from "../kernel/units.ts";
import type { ApproachRun, PlaneStep } from "../program/tools/plane-types.ts";
import type { Run } from "../program/state/run-types.ts";

const number = (n: number) => (Number(n.toFixed(3)) || 0).toFixed(3);

/** One line for a move, X as a diameter: for goldens and bug reports. */
export function moveLine(m: Move): string {
  const at = `X${number(toDiameter(m.to.r))} Z${number(m.to.z)}`;
  const why =
    `${m.phase}${m.pass === undefined ? "" : ` pass ${m.pass}`} ${m.run} step ${m.step}` +
    (m.phase !== "position" && m.plunging ? " plunging" : "");
  switch (m.kind) {
    case "rapid":
      return `rapid  ${at} | ${why}`;
    case "feed":
      return m.dwell === undefined
        ? `feed   ${at} F${m.feed} ${m.feedUnit} | ${why}`
        : `dwell  ${at} ${m.dwell} rev | ${why}`;
    case "arc":
      return `arc    ${at} ${m.turn} CX${number(toDiameter(m.centre.r))} CZ${number(m.centre.z)} F${m.feed} ${m.feedUnit} | ${why}`;
    case "thread":
      return `thread ${at} P${number(m.pitch)} | ${why}`;
  }
}

/** One line for a motion of a mill. */
/** The centre of an arc in XZ or YZ, in the order of the axes. */
const sideOf = ({ side }: PlaneStep): string =>
  side
    ? ` ${side.turn}` +
      (["x", "y", "z"] as const)
        .map((k) => (side.centre[k] === undefined ? "" : ` C${k.toUpperCase()}${number(side.centre[k])}`))
        .join("")
    : "";

function planeLine(s: PlaneStep): string {
  const at = `X${number(s.to.x)} Y${number(s.to.y)}${s.to.z === null ? "" : ` Z${number(s.to.z)}`}`;
  const feed = s.feed === undefined ? "" : ` F${s.feed} ${s.feedUnit}`;
  return (
    `${s.kind.padEnd(6)} ${at}` +
    (s.centre ? ` ${s.turn} CX${number(s.centre.x)} CY${number(s.centre.y)}` : "") +
    `${sideOf(s)}${feed} | block ${s.block}, tool radius ${s.radius}`
  );
}

/** The points of an approach or a departure, in the plane it runs in. */
function approachLine(a: ApproachRun): string {
  const points = Object.entries(a.points).map(([name, p]) =>
    a.plane === "XY"
      ? `${name} X${number(p.x)} Y${number(p.y)}`
      : `${name} X${number(toDiameter(radius(p.y)))} Z${number(p.x)}`,
  );
  return `# block ${a.block}: ${a.departing ? "DEP" : "APPR"} ${a.form}: ${points.join(", ")}`;
}

/** A run as text: operations, moves by block, findings. */
export function listing(run: Run): string {
  const lines: string[] = [];
  let operation: number | null = -1;
  run.steps.forEach((s) => {
    if (s.operation !== operation) {
      operation = s.operation;
      const o = operation === null ? null : run.operations[operation];
      lines.push(
        o
          ? `# block ${o.block}: cycle ${o.cycle}, tool ${o.tool.T}, ${o.plan.passes} passes of ${number(o.plan.infeed)}` +
              `, ${number(o.seconds)} s`
          : "# between cycles",
      );
    }
    lines.push(moveLine(s.move));
  });
  if (run.plane.length > 0) lines.push("# milling", ...run.plane.map(planeLine));
  lines.push(...run.approaches.map(approachLine));
  for (const f of run.issues)
    lines.push(
      `! ${f.issue.severity} ${f.issue.code}` +
        ("at" in f.issue && f.issue.at ? ` ${f.issue.at}` : "") +
        (f.block === null ? "" : ` in block ${f.block}, line ${f.line}`),
    );
  return `${lines.join("\n")}\n`;
}
