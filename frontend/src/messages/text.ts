/** Texts as data, as the station sends them. The Python counterpart is app/crenel/messages/message.py. */

import type { Places } from "./places";

/** The id of one of the client's own texts. */
export type MessageId = keyof Places;
/** One without placeholders, rendered where it is shown. */
export type PlainId = { [Id in MessageId]: [Places[Id]] extends [never] ? Id : never }[MessageId];
export type Values<Id extends MessageId> = [Places[Id]] extends [never] ? [] : [values: Record<Places[Id], Value>];

/** A text of the language files; its values fill its placeholders. */
export interface Message {
  message_id: string;
  values: Record<string, Value>;
}

/** Texts one after the other. */
export interface MessageList {
  items: Text[];
  separator: string;
}

/** A number with its unit; `signed`: with a plus, too. */
export interface Quantity {
  value: number;
  unit: string;
  decimals: number;
  signed: boolean;
}

/** A string is a name, the same in every language. */
export type Text = string | Message | MessageList | Quantity;
export type Value = Text | number;

const SENTENCE = "sentence";

/** One of the client's own texts as data. */
export function message<Id extends MessageId>(id: Id, ...[values]: Values<Id>): Message {
  return { message_id: id, values: values ?? {} };
}

export function quantity(value: number, unit = "", decimals = 0): Quantity {
  return { value, unit, decimals, signed: false };
}

export function signedQuantity(value: number, unit = "", decimals = 0): Quantity {
  return { value, unit, decimals, signed: true };
}

export function isMessage(value: object): value is Message {
  return "message_id" in value && "values" in value && typeof value.message_id === "string";
}

export function isMessageList(value: object): value is MessageList {
  return "items" in value && "separator" in value && Array.isArray(value.items);
}

export function isQuantity(value: object): value is Quantity {
  return "signed" in value && "unit" in value && "value" in value && "decimals" in value;
}

/** Whether a text equals or contains another one, regardless of numbers. */
export function mentions(text: Value, other: Text): boolean {
  const wanted = inner(other);
  if (typeof text !== "object") return text === wanted;
  if (isMessage(text)) {
    const same = typeof wanted === "object" && isMessage(wanted) && wanted.message_id === text.message_id;
    return same || Object.values(text.values).some((value) => mentions(value, wanted));
  }
  return isMessageList(text) && text.items.some((item) => mentions(item, wanted));
}

/** A sentence is its text, with a capital letter and a full stop. */
function inner(text: Text): Text {
  if (typeof text !== "object" || !isMessage(text) || text.message_id !== SENTENCE) return text;
  return (text.values.text ?? "") as Text;
}
