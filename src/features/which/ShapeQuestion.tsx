import type { ReactNode } from "react";
import type { WhichTexts } from "../../i18n/which-text.ts";
import type { TurnedShape } from "../../cycles/define.ts";
import type { Site } from "../../cycles/shape-request.ts";
import { Message } from "../../app/base/Message.tsx";
import { ThreadField } from "./ThreadField.tsx";
import { NumberField } from "../../app/fields/setup/NumberField.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import {
  REQUEST_FIELDS,
  canBePreturned,
  measuresOf,
  type OperationRequest,
  type OperationRequestFault,
  type AskedMeasure,
  type StockChoice,
} from "../../app/document/operation-request.ts";

const SITES = ["outside", "inside", "face"] as const satisfies readonly Site[];
const SHAPES = ["step", "plunge", "free", "groove", "thread"] as const satisfies readonly TurnedShape[];

interface Props {
  readonly words: WhichTexts;
  readonly asking: OperationRequest;
  readonly fault: OperationRequestFault | null;
  /** Whether the question is about an open work, whose stock is known. */
  readonly inWork: boolean;
  readonly onAsk: (change: Partial<OperationRequest>) => void;
}

/** One select within the sentence. */
function Choice<T extends string>({
  label,
  of,
  among,
  value,
  onChoose,
}: {
  readonly label: string;
  readonly of: Readonly<Record<T, string>>;
  readonly among: readonly T[];
  readonly value: T;
  readonly onChoose: (value: T) => void;
}) {
  return (
    <select
      className="select which-choice"
      aria-label={label}
      value={value}
      onChange={(e) => {
        const chosen = among.find((each) => each === e.target.value);
        if (chosen) onChoose(chosen);
      }}
    >
      {among.map((each) => (
        <option key={each} value={each}>
          {of[each]}
        </option>
      ))}
    </select>
  );
}

/** The wanted shape as a sentence with selects, and its numbers below. */
export function ShapeQuestion({ words, asking, fault, inWork, onAsk }: Props) {
  const {
    setup: { units },
  } = useTexts();
  const stocks: readonly StockChoice[] = [
    "solid",
    ...(canBePreturned(asking.shape) ? (["preturned"] as const) : []),
    ...(inWork ? (["now"] as const) : []),
  ];
  const slots: Readonly<Record<string, ReactNode>> = {
    site: (
      <Choice
        label={words.site.label}
        of={words.site.of}
        among={SITES}
        value={asking.site}
        onChoose={(site) => onAsk({ site })}
      />
    ),
    shape: (
      <Choice
        label={words.shape.label}
        of={words.shape.of}
        among={SHAPES}
        value={asking.shape}
        onChoose={(shape) => onAsk({ shape })}
      />
    ),
    stock: (
      <Choice
        label={words.stock.label}
        of={words.stock.of}
        among={stocks}
        value={asking.stock}
        onChoose={(stock) => onAsk({ stock })}
      />
    ),
  };
  const nameOf = (m: AskedMeasure) =>
    m === "d1" && asking.shape === "thread" ? words.threadDiameter : words.measures[m];
  const unitOf = (m: AskedMeasure) =>
    m === "d1" || m === "d2" ? units.diameter : m === "angle" ? words.degrees : units.mm;
  return (
    <>
      <p className="which-sentence">
        {words.sentence.split(/\{(\w+)\}/).map((part, i) => (
          <span key={i}>{i % 2 === 0 ? part : slots[part]}</span>
        ))}
      </p>
      {asking.shape === "thread" && asking.site !== "face" && (
        <ThreadField
          thread={asking.thread ?? null}
          inside={asking.site === "inside"}
          onThread={(thread) => onAsk({ thread })}
        />
      )}
      <div className="which-measures">
        {measuresOf(asking).map((m) => (
          <div key={m}>
            <NumberField
              field={REQUEST_FIELDS[m]}
              name={nameOf(m)}
              unit={unitOf(m)}
              text={asking.typed[m]}
              onText={(text) => onAsk({ typed: { ...asking.typed, [m]: text } })}
            />
            <div role="status">{fault?.at === m && <Message tone="error">{words.faults[fault.code]}</Message>}</div>
          </div>
        ))}
      </div>
    </>
  );
}
