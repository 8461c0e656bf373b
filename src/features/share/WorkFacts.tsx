import { useMemo, type ReactNode } from "react";
import type { HandedTexts } from "../../i18n/en/handed.ts";
import { formatNumber } from "../../i18n/number.ts";
import { parse } from "../../nc/parse.ts";
import { textOf } from "../../app/document/printed.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { nameOfMachine } from "./machine-name.ts";
import { filesOf, isProgram, textsOf, type Work } from "../../app/document/work.ts";

/** Stored size of a text, bytes. */
const sizeOf = (text: string): number => new TextEncoder().encode(text).length;

/** Number of blocks, and size in bytes. */
function sizesOfWork(work: Work) {
  const blocks = parse(textOf(work)).blocks.filter(({ statement }) => statement.kind !== "empty").length;
  const size = (isProgram(work) ? textsOf(work).map((file) => file.text) : [JSON.stringify(work)]).reduce(
    (sum, each) => sum + sizeOf(each),
    0,
  );
  return { blocks, size };
}

/** The contents of a work, fact by fact; `tools` and `control` include the differences to this device. */
export function WorkFacts({
  words,
  work,
  tools,
  control,
  machine,
}: {
  readonly words: HandedTexts;
  readonly work: Work;
  readonly tools: ReactNode;
  readonly control: ReactNode;
  readonly machine: string;
}) {
  const { menu } = useTexts("first");
  const language = useSettings((s) => s.language);
  const { blocks, size } = useMemo(() => sizesOfWork(work), [work]);
  const files = isProgram(work) ? filesOf(work) : [];
  const facts: readonly (readonly [keyof HandedTexts["facts"], ReactNode])[] = [
    ["name", work.name],
    ["kind", isProgram(work) ? words.program : words.cycle(work.cycle, menu.of[work.cycle]?.name ?? "")],
    ["blocks", formatNumber(language, blocks)],
    ...(files.length > 0 ? [["files", files.map(({ name }) => name).join(", ")] as const] : []),
    ["tools", tools],
    ["control", control],
    ["machine", nameOfMachine(words, machine)],
    ["size", words.kilobytes(formatNumber(language, size / 1000, 1))],
  ];
  return (
    <dl className="modal-facts">
      {facts.map(([fact, value]) => (
        <div key={fact}>
          <dt>{words.facts[fact]}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
