import { memo, useLayoutEffect, useRef } from "react";
import type { DeviceTexts } from "../../i18n/en/device.ts";
import type { Thumbnail } from "../../view/thumbnail.ts";
import { Icon } from "../../app/base/Icon.tsx";
import type { WorkSummary } from "../../app/records/device.ts";
import { ProgramThumbnail } from "../../app/fields/kept/ProgramThumbnail.tsx";

/** The commands of a row. */
export type RowAction =
  | { readonly what: "open" | "rename" | "stay" | "duplicate" | "remove" | "select" }
  | { readonly what: "call"; readonly name: string };

interface Props {
  readonly of: WorkSummary;
  readonly seen: Thumbnail | undefined;
  /** The kind of work: the name of its cycle, or a program. */
  readonly kind: string;
  /** Note of a course task; null for other works. */
  readonly task: string | null;
  readonly about: string;
  /** Note of a work that is open in another tab; null for others. */
  readonly elsewhere: string | null;
  readonly selected: boolean;
  readonly renaming: boolean;
  readonly t: DeviceTexts["works"];
  readonly onWish: (work: WorkSummary, wish: RowAction) => void;
}

/** The field of a new name: Enter applies it, Escape cancels. */
function NameField({
  name,
  label,
  onDone,
}: {
  readonly name: string;
  readonly label: string;
  readonly onDone: (name: string | null) => void;
}) {
  const input = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => {
    input.current?.focus();
    // The extension of a file is not selected, so that it stays unless edited on purpose.
    input.current?.setSelectionRange(0, name.replace(/\.[^.]{1,4}$/, "").length);
  }, [name]);
  return (
    <input
      ref={input}
      className="input number"
      type="text"
      defaultValue={name}
      aria-label={label}
      maxLength={80}
      spellCheck={false}
      autoComplete="off"
      onBlur={(event) => onDone(event.currentTarget.value)}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") onDone(event.currentTarget.value);
        if (event.key === "Escape") onDone(null);
      }}
    />
  );
}

/** One work of the list: a picture, its name and kind, and its actions. */
export const WorkRow = memo(function WorkRow({
  of,
  seen,
  kind,
  task,
  about,
  elsewhere,
  selected,
  renaming,
  t,
  onWish,
}: Props) {
  const { name, cycle, work } = of;
  const does = (what: Exclude<RowAction["what"], "call">) => () => onWish(of, { what });
  return (
    <li className="work-row" data-work={work}>
      <label className="work-select">
        <input type="checkbox" aria-label={t.select(name)} checked={selected} onChange={does("select")} />
      </label>
      {renaming ? (
        <div className="work-open">
          <ProgramThumbnail seen={seen} cycle={cycle} />
          <NameField
            name={name}
            label={t.newName(name)}
            onDone={(typed) => onWish(of, typed === null ? { what: "stay" } : { what: "call", name: typed })}
          />
        </div>
      ) : (
        <button type="button" className="button plain work-open" aria-label={t.open(name)} onClick={does("open")}>
          <ProgramThumbnail seen={seen} cycle={cycle} />
          <span className="kept-words">
            <b className="kept-name">{name}</b>
            <span className="small">
              {cycle !== null && <span className="number card-number">{cycle}</span>}{" "}
              {[task, kind].filter((each) => each !== null).join(" · ")}
            </span>
            <span className="soft small">{about}</span>
            {elsewhere !== null && <span className="small work-elsewhere">{elsewhere}</span>}
          </span>
        </button>
      )}
      <div className="work-tools">
        <button
          type="button"
          className="button icon plain"
          aria-label={t.rename(name)}
          title={t.rename(name)}
          disabled={elsewhere !== null}
          onClick={does("rename")}
        >
          <Icon name="rename" />
        </button>
        <button
          type="button"
          className="button icon plain"
          aria-label={t.duplicate(name)}
          title={t.duplicate(name)}
          onClick={does("duplicate")}
        >
          <Icon name="copy" />
        </button>
        <button
          type="button"
          className="button icon plain"
          aria-label={t.remove(name)}
          title={t.remove(name)}
          disabled={elsewhere !== null}
          onClick={does("remove")}
        >
          <Icon name="remove" />
        </button>
      </div>
    </li>
  );
});
