import { useId, type ReactNode } from "react";
import { NumberInput, type NumberInputProps } from "./NumberInput.tsx";
import { useBegunSign } from "./use-begun-sign.ts";

interface Props extends NumberInputProps {
  /** Class of the whole field, which lays out its parts. */
  readonly className: string;
  readonly label: ReactNode;
  /** Next to the label. */
  readonly more?: ReactNode;
  readonly unit?: ReactNode;
  /** After the unit. */
  readonly button?: ReactNode;
  /** Value used while the field is empty. */
  readonly hint?: ReactNode;
  /** Problems, read out when they change. */
  readonly messages: ReactNode;
}

/** A field with label and unit, and its messages below. */
export function LabelledInput({ className, label, more, unit, button, hint, messages, ...input }: Props) {
  const id = useId();
  const { isBegun, onTyped, onLeft } = useBegunSign(input.text);
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
        <NumberInput
          id={id}
          aria-describedby={`${id}-unit ${id}-hint ${id}-messages`}
          {...input}
          {...(isBegun && { "aria-invalid": false })}
          onText={(text) => {
            onTyped(text);
            input.onText(text);
          }}
          onLeave={() => {
            onLeft();
            input.onLeave?.();
          }}
        />
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
        {!isBegun && messages}
      </div>
    </div>
  );
}
