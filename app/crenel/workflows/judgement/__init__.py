"""What a verification's figures are judged by, and the sentence for each decision."""
