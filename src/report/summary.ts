import type { Report, ReportOperation } from "./report.ts";

const fixed = (n: number, decimals: number) => String(Number(n.toFixed(decimals)));

/** Minutes and seconds. */
function duration(seconds: number): string {
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")} min`;
}

const operationLine = (o: ReportOperation) =>
  `  block ${o.block}: cycle ${o.cycle}, tool ${o.tool["T"]} ${o.tool["NAME"]}, from X${fixed(o.start.x, 3)} Z${fixed(o.start.z, 3)}: ` +
  `${o.passes} passes of ${fixed(o.infeed, 3)} mm, ${o.moves.length} moves, ${duration(o.seconds)}`;

/** A report for reading: what runs, what the proof says, and every finding with its block. */
export function summary(r: Report): string {
  const { gouge, rapidInStock, residual } = r.proof;
  const left = residual.reduce((sum, piece) => sum + piece.area, 0);
  const count = (severity: string) => r.issues.filter((i) => i.severity === severity).length;
  return [
    `${r.file}: ${r.program.name || "(no name)"}, ${r.program.unit}, ${r.program.blocks} blocks`,
    ...r.operations.map(operationLine),
    `  proof: gouge ${fixed(gouge, 3)} mm², rapid in stock ${fixed(rapidInStock, 3)} mm², left ${fixed(left, 3)} mm² in ${residual.length} places`,
    ...r.issues.map((i) => `  ${i.severity}${i.block === undefined ? "" : ` in block ${i.block}`}${i.at === undefined ? "" : ` (${i.at})`}: ${i.text}`),
    `  ${count("error")} errors, ${count("warning")} warnings`,
    "",
  ].join("\n");
}
