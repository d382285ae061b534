import { Modal } from "@mantine/core";
import { useState } from "react";

import { PressButton } from "../../controls/PressButton";
import { TextField } from "../../controls/TextField";
import { t } from "../../state/language";
import { useLive } from "../../state/store";
import styles from "./CertificateForm.module.css";

/** Who issues a certificate. */
export interface Issuer {
  laboratory: string;
  /** ISO 3166-1, two capital letters. */
  country: string;
}

interface CertificateFormProps {
  opened: boolean;
  onClose: () => void;
  onIssue: (issuer: Issuer) => Promise<void>;
}

const KEYS = { laboratory: "crenel-laboratory", country: "crenel-country" };

/** Asks who issues a certificate; this browser remembers it. */
export function CertificateForm({ opened, onClose, onIssue }: CertificateFormProps) {
  const station = useLive((s) => s.station?.name ?? "");
  const [laboratory, setLaboratory] = useState(() => localStorage.getItem(KEYS.laboratory) ?? station);
  const [country, setCountry] = useState(() => localStorage.getItem(KEYS.country) ?? "");
  const issuer = { laboratory: laboratory.trim(), country: country.trim() };
  const complete = issuer.laboratory !== "" && /^[A-Z]{2}$/.test(issuer.country);
  const issue = async () => {
    localStorage.setItem(KEYS.laboratory, issuer.laboratory);
    localStorage.setItem(KEYS.country, issuer.country);
    onClose();
    await onIssue(issuer);
  };
  const title = t("ui-calibration-certificate-dcc");
  return (
    <Modal
      opened={opened}
      onClose={onClose}
      withCloseButton={false}
      centered
      radius="md"
      size="md"
      attributes={{ content: { "aria-label": title } }}
    >
      <div className={styles.form}>
        <h2 className={styles.title}>{title}</h2>
        <p className={styles.text}>{t("ui-certificate-is-not-signed")}</p>
        <TextField
          label={t("ui-laboratory")}
          value={laboratory}
          maxLength={200}
          autoComplete="organization"
          data-autofocus
          onText={setLaboratory}
        />
        <TextField
          label={t("ui-country-of-the-laboratory")}
          value={country}
          maxLength={2}
          placeholder="DE"
          autoComplete="country"
          onText={(text) => setCountry(text.toUpperCase())}
        />
        <PressButton free kind="primary" disabled={!complete} onPress={issue}>
          {t("ui-save-the-certificate")}
        </PressButton>
        <PressButton free kind="quiet" onPress={onClose}>
          {t("ui-cancel")}
        </PressButton>
      </div>
    </Modal>
  );
}
