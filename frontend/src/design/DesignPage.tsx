import type { ReactNode } from "react";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { PressButton } from "../controls/PressButton";
import form from "../datasheets/Datasheets.module.css";
import { Layout } from "../frame/Layout";
import { t } from "../state/language";
import styles from "./Design.module.css";
import { type DesignFile, DesignFiles } from "./DesignFiles";

interface DesignPageProps {
  title: string;
  text: string;
  /** What is filled in. */
  children: ReactNode;
  picture: ReactNode;
  files: DesignFile[];
  /** The design is that of what stands in the fields. */
  ready: boolean;
  why: string;
  /** What the way to a datasheet says. */
  take?: string;
  onTake: () => Promise<void> | void;
  onBack: () => void;
}

/** The frame of a design: its fields, its picture, its files, and the way to a datasheet. */
export function DesignPage({
  title,
  text,
  children,
  picture,
  files,
  ready,
  why,
  onTake,
  onBack,
  ...rest
}: DesignPageProps) {
  return (
    <Layout
      picture={picture}
      card={
        <>
          <CardHead title={title} text={text} />
          <div className={styles.fields} data-design>
            {children}
          </div>
          <DesignFiles files={files} disabled={!ready} />
          <div className={form.save}>
            <MainAct>
              <PressButton kind="primary" disabled={!ready} why={why} onPress={onTake}>
                {rest.take ?? t("ui-take-the-design-over")}
              </PressButton>
            </MainAct>
          </div>
          <div className={form.foot}>
            <PressButton free kind="quiet" onPress={onBack}>
              {t("ui-back-to-the-list")}
            </PressButton>
          </div>
        </>
      }
    />
  );
}
