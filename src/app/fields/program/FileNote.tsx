import { Icon } from "../../base/Icon.tsx";

interface Props {
  readonly text: string;
  /** What is shown is no file that a control loads. */
  readonly warns?: boolean;
  readonly cure?: { readonly name: string; readonly go: () => void };
}

/** One line above the ways out of a program: which control it is for, and in which form it leaves. */
export function FileNote({ text, warns = false, cure }: Props) {
  return (
    <p className={`small program-file${warns ? " field-message warning" : " soft"}`}>
      {warns && <Icon name="warning" />} <span>{text}</span>
      {cure && (
        <button type="button" className="button plain" onClick={cure.go}>
          {cure.name}
        </button>
      )}
    </p>
  );
}
