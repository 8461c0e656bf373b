import { useEffect, useId, useState, type KeyboardEvent, type PointerEvent, type RefObject } from "react";

/** Options that Page up and Page down go by. */
const PAGE = 8;

const STEPS: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowUp: -1, PageDown: PAGE, PageUp: -PAGE };

/** What is typed in a combobox, and its chosen option. */
export interface Combobox {
  readonly id: string;
  readonly typed: string;
  readonly chosen: number;
  readonly change: (next: { readonly typed?: string; readonly chosen: number }) => void;
}

/** `chosen`: the option that Enter takes before anything is typed; −1: none. */
export function useCombobox(chosen = 0, typed = ""): Combobox {
  const id = useId();
  const [state, set] = useState({ typed, chosen: typed === "" ? chosen : 0 });
  return { id, ...state, change: (next) => set((before) => ({ ...before, ...next })) };
}

const chosenOf = ({ chosen }: Combobox, count: number): number => Math.min(chosen, count - 1);
const optionId = ({ id }: Combobox, index: number): string => `${id}${index}`;

/** The attributes of an option in the list, which has the id of the combobox and the role "listbox". */
export const optionOf = (box: Combobox, index: number, count: number) => ({
  id: optionId(box, index),
  role: "option",
  "aria-selected": index === chosenOf(box, count),
  // The field keeps the focus.
  onPointerDown: (event: PointerEvent) => event.preventDefault(),
});

/** The field of a combobox: one types, arrow keys choose among the `count` options below it, Enter takes one. */
export function ComboboxInput({
  box,
  count,
  label,
  take,
  className,
  input,
  placeholder = label,
  describedBy,
  field = {},
}: {
  readonly box: Combobox;
  readonly count: number;
  readonly label: string;
  readonly take: (index: number) => void;
  readonly className: string;
  readonly input?: RefObject<HTMLInputElement | null>;
  /** By default the label, where nothing else shows it. */
  readonly placeholder?: string;
  readonly describedBy?: string;
  /** Names of the field for the form around it. */
  readonly field?: Readonly<Record<`data-${string}`, string>>;
}) {
  const at = chosenOf(box, count);
  const option = at < 0 ? undefined : optionId(box, at);
  useEffect(() => {
    if (option !== undefined) document.getElementById(option)?.scrollIntoView?.({ block: "nearest" });
  }, [option, box.typed]);
  const onKey = (event: KeyboardEvent) => {
    const step = STEPS[event.key];
    if (event.key === "Enter") {
      // With nothing typed and nothing chosen, Enter is that of the form around the field.
      if (at >= 0 || box.typed !== "") event.preventDefault();
      if (at >= 0) take(at);
    } else if (step !== undefined && count > 0) {
      event.preventDefault();
      // One step goes around the ends, a page stops there.
      const next = at + step;
      box.change({
        chosen: Math.abs(step) === 1 ? (next + count) % count : Math.max(0, Math.min(count - 1, next)),
      });
    }
  };
  return (
    <input
      {...field}
      ref={input}
      type="text"
      className={className}
      role="combobox"
      aria-label={label}
      placeholder={placeholder}
      aria-describedby={describedBy}
      aria-expanded={count > 0}
      aria-controls={box.id}
      aria-autocomplete="list"
      aria-activedescendant={option}
      enterKeyHint="go"
      autoComplete="off"
      autoCapitalize="none"
      spellCheck={false}
      value={box.typed}
      onKeyDown={onKey}
      onChange={(event) => box.change({ typed: event.currentTarget.value, chosen: 0 })}
    />
  );
}
