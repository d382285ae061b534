import { createContext, useContext } from "react";
import rows from "../controls/List.module.css";
import { Banners } from "../frame/Banners";
import health from "../health/Health.module.css";
import { bodySchema, type OpenApi, type Route, routesByGroup, type Schema, typeText } from "../reference/openapi";
import { addressOf } from "../state/base";
import { t } from "../state/language";
import { useRead } from "../state/useRead";
import records from "./RecordsPage.module.css";
import styles from "./ReferencePage.module.css";

/** The names of all data types that are described. */
const DataTypes = createContext<ReadonlySet<string>>(new Set());

/** The station's HTTP interface, for people who write programs for it. */
export function ReferencePage() {
  const { value: description } = useRead<OpenApi>("/api/openapi.json"); // a lost connection has its own banner
  return (
    <main className={records.page}>
      {description ? (
        <Reference description={description} />
      ) : (
        <h1 className="visually-hidden">{t("ui-http-interface")}</h1>
      )}
      <Banners />
    </main>
  );
}

function Reference({ description }: { description: OpenApi }) {
  const schemas = description.components?.schemas ?? {};
  const shapes = Object.entries(schemas);
  return (
    <DataTypes value={new Set(Object.keys(schemas))}>
      <div className={records.records}>
        <section className={health.section}>
          <h1 className={rows.heading}>{t("ui-http-interface-version", { version: description.info.version })}</h1>
          <p>
            {t("ui-http-interface-explained")}{" "}
            <a className={styles.link} href={addressOf("/api/openapi.json")}>
              openapi.json
            </a>
          </p>
        </section>
        {[...routesByGroup(description)].map(([group, routes]) => (
          <section key={group} className={health.section} aria-label={group}>
            <h2 className={styles.group}>{group}</h2>
            {routes.map((route) => (
              <RouteEntry key={`${route.method} ${route.path}`} route={route} />
            ))}
          </section>
        ))}
        <section className={health.section} aria-label={t("ui-data-types")}>
          <h2 className={styles.group}>{t("ui-data-types")}</h2>
          {shapes.map(([name, schema]) => (
            <Shape key={name} name={name} schema={schema} />
          ))}
        </section>
      </div>
    </DataTypes>
  );
}

/** Without the code marks of docstrings. */
function plain(description = ""): string {
  return description.replaceAll("``", "");
}

function RouteEntry({ route }: { route: Route }) {
  const taken = bodySchema(route.requestBody);
  const answered = bodySchema(route.responses["200"]);
  return (
    <article className={styles.entry}>
      <h3>
        <span className={styles.method} data-reads={route.method === "GET"}>
          {route.method}
        </span>{" "}
        <code>{route.path}</code>
      </h3>
      <p>{plain(route.description)}</p>
      <dl>
        {(route.parameters ?? []).map((parameter) => (
          <Line key={parameter.name} name={parameter.name} schema={parameter.schema} />
        ))}
        {taken && <Line name={t("ui-request-body")} schema={taken} />}
        {answered && <Line name={t("ui-answer")} schema={answered} />}
      </dl>
    </article>
  );
}

function Shape({ name, schema }: { name: string; schema: Schema }) {
  const required = new Set(schema.required);
  return (
    <article className={styles.entry} id={`type-${name}`}>
      <h3>
        <code>{name}</code>
      </h3>
      <p>{plain(schema.description)}</p>
      <dl>
        {Object.entries(schema.properties ?? {}).map(([field, one]) => (
          <Line key={field} name={required.has(field) ? field : `${field}?`} schema={one} />
        ))}
      </dl>
    </article>
  );
}

/** A name with its type; each data type in it leads to its description. */
function Line({ name, schema }: { name: string; schema: Schema }) {
  const known = useContext(DataTypes);
  const parts = typeText(schema).split(/\b([A-Z]\w+)\b/);
  return (
    <div className={styles.line}>
      <dt>{name}</dt>
      <dd>
        <code>
          {parts.map((part, index) =>
            known.has(part) ? (
              <a className={styles.link} key={`${index} ${part}`} href={`#type-${part}`}>
                {part}
              </a>
            ) : (
              part
            ),
          )}
        </code>
      </dd>
    </div>
  );
}
