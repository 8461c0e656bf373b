import { blockNumbers, type Program } from "../../nc/program.ts";

/** Longer programs are one text: nobody looks for the place where a block breaks in them. */
const MOST_BLOCKS = 4000;

/** The program with its block numbers, also where the file has none. */
export function SheetProgram({ program, name }: { readonly program: Program; readonly name: string }) {
  const numbers = blockNumbers(program);
  const shown = program.blocks.flatMap(({ raw, number, statement }, i) => {
    const text = raw.replace(/[\r\n]+$/, "");
    if (text.trim() === "") return [];
    const silent = statement.kind === "empty" || (statement.kind === "comment" && number === null);
    return [number === null && !silent ? `${numbers[i] ?? ""} ${text}` : text];
  });
  return (
    <section className="sheet-program">
      <h2>{name}</h2>
      {shown.length > MOST_BLOCKS ? <pre>{shown.join("\n")}</pre> : <ol>{shown.map((text, i) => <li key={i}>{text}</li>)}</ol>}
    </section>
  );
}
