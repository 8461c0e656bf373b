import { blockNumbers, type Program } from "../../nc/program.ts";

/** Longer programs are printed as one text, without page breaks between blocks. */
const MOST_BLOCKS = 4000;

/** The blocks of a program with their numbers, even if the file has none. */
function blocksOf(program: Program): readonly string[] {
  const numbers = blockNumbers(program);
  return program.blocks.flatMap(({ raw, number, statement }, i) => {
    const text = raw.replace(/(?<![\r\n])[\r\n]+$/, "");
    if (text.trim() === "") return [];
    const silent = statement.kind === "empty" || (statement.kind === "comment" && number === null);
    return [number === null && !silent ? `${numbers[i] ?? ""} ${text}` : text];
  });
}

/** The program as exported: block by block in Klartext, or its DIN/ISO file. */
export function SheetProgram({
  program,
  iso,
  name,
}: {
  readonly program: Program;
  readonly iso: string | null;
  readonly name: string;
}) {
  const shown = iso === null ? blocksOf(program) : iso.trimEnd().split(/\r?\n/);
  return (
    <section className="sheet-program">
      <h2>{name}</h2>
      {shown.length > MOST_BLOCKS ? (
        <pre>{shown.join("\n")}</pre>
      ) : (
        <ol>
          {shown.map((text, i) => (
            <li key={i}>{text}</li>
          ))}
        </ol>
      )}
    </section>
  );
}
