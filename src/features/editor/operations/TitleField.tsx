import { useTexts } from "../../../app/base/settings/use-texts.ts";

interface Props {
  readonly title: string;
  readonly onTitle: (title: string) => void;
  /** Shown below the field. */
  readonly hint?: string;
}

/** The title of an operation: a structure item before its blocks. */
export function TitleField({ title, onTitle, hint }: Props) {
  const { operations: t } = useTexts();
  return (
    <label className="wide">
      <span>{t.title}</span>
      <input
        className="input"
        type="text"
        maxLength={60}
        autoComplete="off"
        value={title}
        onFocus={(event) => event.currentTarget.select()}
        onChange={(event) => onTitle(event.currentTarget.value)}
      />
      {hint !== undefined && <span className="small soft">{hint}</span>}
    </label>
  );
}
