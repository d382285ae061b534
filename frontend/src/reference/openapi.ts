/** The station's description of its HTTP interface (OpenAPI 3.1), as far as it is shown. */

export interface Schema {
  $ref?: string;
  type?: string;
  const?: unknown;
  enum?: unknown[];
  items?: Schema;
  prefixItems?: Schema[];
  anyOf?: Schema[];
  oneOf?: Schema[];
  properties?: Record<string, Schema>;
  required?: string[];
  description?: string;
}

export interface Parameter {
  name: string;
  in: string;
  required?: boolean;
  schema: Schema;
}

interface Content {
  content?: Record<string, { schema?: Schema }>;
}

export interface Operation {
  description?: string;
  parameters?: Parameter[];
  requestBody?: Content;
  responses: Record<string, Content>;
}

export interface OpenApi {
  info: { version: string };
  paths: Record<string, Record<string, Operation>>;
  components?: { schemas?: Record<string, Schema> };
}

export interface Route extends Operation {
  method: string;
  path: string;
}

/** Routes by the first part of their path below /api, each group in the order of the description. */
export function routesByGroup({ paths }: OpenApi): Map<string, Route[]> {
  const groups = new Map<string, Route[]>();
  for (const [path, operations] of Object.entries(paths)) {
    const [, group = path] = /^\/api\/([^/.{]+)/.exec(path) ?? [];
    const routes = groups.get(group) ?? [];
    for (const [method, operation] of Object.entries(operations)) {
      routes.push({ ...operation, method: method.toUpperCase(), path });
    }
    groups.set(group, routes);
  }
  return groups;
}

/** The schema of a JSON body; null where there is none, or none is given. */
export function bodySchema(content: Content | undefined): Schema | null {
  const schema = content?.content?.["application/json"]?.schema;
  return schema && Object.keys(schema).length > 0 ? schema : null;
}

function shapeName(ref: string): string {
  return ref.slice(ref.lastIndexOf("/") + 1);
}

/** A schema in the notation of TypeScript; a shape by its name. */
export function typeText(schema: Schema): string {
  if (schema.$ref) return shapeName(schema.$ref);
  if (schema.const !== undefined) return JSON.stringify(schema.const);
  if (schema.enum) return schema.enum.map((value) => JSON.stringify(value)).join(" | ");
  const union = schema.anyOf ?? schema.oneOf;
  if (union) return union.map(typeText).join(" | ");
  if (schema.prefixItems) return `[${schema.prefixItems.map(typeText).join(", ")}]`;
  if (schema.type === "array") {
    const item = typeText(schema.items ?? {});
    return item.includes(" | ") ? `(${item})[]` : `${item}[]`;
  }
  return schema.type ?? "any";
}
