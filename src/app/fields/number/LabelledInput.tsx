import { useId, type ReactNode } from "react";
import { NumberInput, type NumberInputProps } from "./NumberInput.tsx";

interface Props extends NumberInputProps {
  /** Of the whole field, which lays out its parts. */
  readonly className: string;
  readonly label: ReactNode;
  /** Beside the label. */
  readonly more?: ReactNode;
  readonly unit?: ReactNode;
  /** Behind the unit. */
  readonly button?: ReactNode;
  /** What holds while the field is empty. */
  readonly hint?: ReactNode;
  /** What is wrong with it, read out when it changes. */
  readonly messages: ReactNode;
}

/** A field with its label, its unit, and what is said about it below. */
export function LabelledInput({ className, label, more, unit, button, hint, messages, ...input }: Props) {
  const id = useId();
  const name = <label htmlFor={id}>{label}</label>;
  return (
    <div className={className}>
      {more === undefined ? (
        name
      ) : (
        <span className="field-name">
          {name}
          {more}
        </span>
      )}
      <span className="field-value">
        <NumberInput id={id} aria-describedby={`${id}-unit ${id}-hint ${id}-messages`} {...input} />
        {unit !== undefined && (
          <span className="soft small" id={`${id}-unit`}>
            {unit}
          </span>
        )}
        {button}
      </span>
      {hint && (
        <p className="field-hint small soft" id={`${id}-hint`}>
          {hint}
        </p>
      )}
      <div className="field-messages" id={`${id}-messages`} role="status">
        {messages}
      </div>
    </div>
  );
}
