import type { Move } from "../kernel/move.ts";
import { toDiameter } from "../kernel/units.ts";
import type { Run } from "../program/run-types.ts";

const number = (n: number) => (Number(n.toFixed(3)) || 0).toFixed(3);

/** One line for a move, X as a diameter: for goldens and bug reports. */
export function moveLine(m: Move): string {
  const at = `X${number(toDiameter(m.to.r))} Z${number(m.to.z)}`;
  const why = `${m.phase}${m.pass === undefined ? "" : ` pass ${m.pass}`} ${m.run} step ${m.step}${m.phase !== "position" && m.plunging ? " plunging" : ""}`;
  switch (m.kind) {
    case "rapid": return `rapid  ${at} | ${why}`;
    case "feed": return `feed   ${at} F${m.feed} ${m.feedUnit} | ${why}`;
    case "arc": return `arc    ${at} ${m.turn} CX${number(toDiameter(m.centre.r))} CZ${number(m.centre.z)} F${m.feed} ${m.feedUnit} | ${why}`;
    case "thread": return `thread ${at} P${number(m.pitch)} | ${why}`;
  }
}

/** A whole run as text: operations, moves by block, findings. */
export function listing(run: Run): string {
  const lines: string[] = [];
  let operation: number | null = -1;
  run.steps.forEach((s) => {
    if (s.operation !== operation) {
      operation = s.operation;
      const o = operation === null ? null : run.operations[operation];
      lines.push(o ? `# block ${o.block}: cycle ${o.cycle}, tool ${o.tool.T}, ${o.plan.passes} passes of ${number(o.plan.infeed)}, ${number(o.seconds)} s` : "# between cycles");
    }
    lines.push(moveLine(s.move));
  });
  for (const f of run.issues) lines.push(`! ${f.issue.severity} ${f.issue.code}${"at" in f.issue && f.issue.at ? ` ${f.issue.at}` : ""}${f.block === null ? "" : ` in block ${f.block}, line ${f.line}`}`);
  return `${lines.join("\n")}\n`;
}
