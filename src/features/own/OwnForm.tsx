import { useRef } from "react";
import { flushSync } from "react-dom";
import { statementLines } from "../../nc/print.ts";
import { LAYOUTS } from "../../nc/style.ts";
import { ownStatement, type OwnEntry, type OwnReading } from "../../program/edits/own-cycle.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { enterNext } from "../../app/fields/number/enter-next.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { addParameter, hasRoom, setHead } from "../../app/fields/blocks/own-edits.ts";
import { OwnField, OwnProblems } from "./OwnField.tsx";
import { ParameterCard } from "./ParameterCard.tsx";

const onEnter = enterNext(".own-add");

interface Props {
  readonly entry: OwnEntry;
  readonly reading: OwnReading;
  readonly name: string;
  readonly onDuplicate: (() => void) | null;
  readonly onRemove: () => void;
}

/** The description of one cycle, and the block that it writes. */
export function OwnForm({ entry, reading, name, onDuplicate, onRemove }: Props) {
  const t = useTexts("tables").own;
  const form = useRef<HTMLElement>(null);
  const at = (field: string) => reading.problems.filter((problem) => problem.at === field);
  const add = () => {
    // Rendered synchronously, so that the next key goes into it.
    const id = flushSync(() => addParameter(entry));
    form.current?.querySelector<HTMLElement>(`[data-parameter="${id}"] input`)?.focus();
  };
  return (
    <section className="own-form" ref={form} aria-label={t.form(name)} onKeyDown={onEnter}>
      <header>
        <h2>{name}</h2>
        <button
          type="button"
          className="button"
          aria-label={t.duplicateLong(name)}
          disabled={!onDuplicate}
          onClick={() => onDuplicate?.()}
        >
          <Icon name="copy" /> {t.duplicate}
        </button>
        <button type="button" className="button" aria-label={t.removeLong(name)} onClick={onRemove}>
          <Icon name="remove" /> {t.remove}
        </button>
      </header>
      <div className="own-names">
        <OwnField
          className="own-number"
          label={t.number}
          text={entry.number}
          problems={at("number")}
          kind="whole"
          onText={(text) => setHead(entry.id, "number", text)}
        />
        <OwnField
          className="own-name"
          label={t.name}
          text={entry.name}
          problems={at("name")}
          onText={(text) => setHead(entry.id, "name", text)}
        />
      </div>
      <p className="small soft">{t.oneText}</p>
      <h3>{t.parameters}</h3>
      <ol className="own-parameters">
        {entry.parameters.map((p, i) => (
          <li key={p.id}>
            <ParameterCard
              cycle={entry.id}
              parameter={p}
              at={i}
              count={entry.parameters.length}
              problems={reading.problems}
            />
          </li>
        ))}
      </ol>
      <div className="field-messages" role="status">
        <OwnProblems problems={at("parameters")} text="." />
      </div>
      <div>
        <button type="button" className="button own-add" disabled={!hasRoom(entry)} onClick={add}>
          <Icon name="add" /> {t.addParameter}
        </button>
      </div>
      {reading.cycle && (
        <figure className="own-text" aria-label={t.text}>
          <figcaption className="panel-title">{t.text}</figcaption>
          <pre className="number" tabIndex={0}>
            {statementLines(ownStatement(reading.cycle), LAYOUTS.tnc7).join("\n")}
          </pre>
        </figure>
      )}
    </section>
  );
}
