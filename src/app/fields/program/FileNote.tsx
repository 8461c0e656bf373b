import { Icon } from "../../base/Icon.tsx";

interface Props {
  readonly text: string;
  /** The shown text is not a file that a control loads. */
  readonly warns?: boolean;
  readonly cure?: { readonly name: string; readonly go: () => void };
}

/** Line above the export buttons: target control and file format. */
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
