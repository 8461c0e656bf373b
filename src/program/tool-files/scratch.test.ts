import { test } from "vitest";
import { readFileSync, readdirSync, statSync } from "node:fs";
import { readToolFiles } from "./read-tool-files.ts";
import { readEntry } from "../tools/tool-entry.ts";
test("x", () => {
  const paths = (process.env["FILES"] ?? "")
    .split(" ")
    .flatMap((p) => (statSync(p).isDirectory() ? readdirSync(p).map((n) => p + "/" + n) : [p]));
  const sets = process.env["SET"] ? [paths] : paths.map((p) => [p]);
  for (const set of sets) {
    const read = readToolFiles(
      set.map((p) => ({ name: p, text: readFileSync(p, "utf8") })),
      "mm",
    );
    for (const { name, content } of read) {
      console.log(
        "==",
        name.split("/").pop(),
        "problem" in content
          ? content.problem
          : "table" in content
            ? `table ${content.table.rows.length}`
            : `${content.foreign.format} tools ${content.foreign.tools.length} refused ${content.foreign.refused.length} unit ${content.foreign.assumedUnit}`,
      );
      if ("foreign" in content) {
        for (const t of content.foreign.tools.slice(0, Number(process.env["MOST"] ?? 12))) {
          const wrong = readEntry({ id: "", cells: { T: "1", ...t.cells } }).issues.map(
            (i) => `${i.severity}:${i.code}@${i.at}`,
          );
          console.log(
            "  ",
            t.label,
            "|",
            Object.entries(t.cells)
              .map(
                ([c, v]) =>
                  `${c}=${v}{${t.origins[c as "T"]?.from}${t.origins[c as "T"]?.why.map((w) => " !" + w).join("")}}`,
              )
              .join(" "),
            "| unused",
            t.unused.join(","),
            "|",
            wrong.join(" "),
          );
        }
        for (const r of content.foreign.refused.slice(0, 5)) console.log("   -", r.label, r.why, r.kind);
      }
    }
  }
});
