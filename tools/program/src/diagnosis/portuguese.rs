//! The texts of the faults in Portuguese. `docs/faults.pt-BR.md` gives the same ones under each fault's number.

use unoclp_core::Cause;

/// What is wrong, in Portuguese; [`Cause::text`] says it in English.
pub const fn portuguese(cause: Cause) -> &'static str {
    match cause {
        Cause::Utf16 => "o arquivo é texto em UTF-16; salve-o como UTF-8 ou ANSI (NC-3)",
        Cause::StrayCharacter => {
            "não é um código: só dígitos, com - na frente e / para comentário (NC-4)"
        }
        Cause::StrayCarriageReturn => {
            "um CR sem LF em seguida; salve com fim de linha CRLF ou LF (NC-3)"
        }
        Cause::NumberTooLarge => "o número não cabe em 32 bits (NC-2)",
        Cause::MinusZero => "-0 não é um código (NC-2)",
        Cause::EmptyFile => "o arquivo não contém nenhum código",
        Cause::NoStart => "o primeiro código deve ser 0, início do programa",
        Cause::SecondStart => "um segundo 0; o início do programa aparece uma só vez, no começo",
        Cause::UnknownCode => "código inexistente",
        Cause::NoSuchInput => "esta placa não tem essa entrada",
        Cause::NoSuchOutput => "esta placa não tem essa saída",
        Cause::NoSuchBranchPoint => "o ponto de ramificação deve ser de 01 a 08 (NC-8)",
        Cause::NoSuchPoint => {
            "não há tal memória, contador, registrador, canal, bit, rótulo ou número"
        }
        Cause::NoSuchTimer => "o programa não tem temporizador com esse número (NC-14)",
        Cause::CloseWithoutOpen => "o 41 fecha um ramo, mas nenhum está aberto (NC-8)",
        Cause::BranchLeftOpen => "este 40 não é fechado por um 41 no seu degrau (NC-8)",
        Cause::RecallBeforeStore => "este degrau não guardou esse ponto de ramificação (NC-8)",
        Cause::NestedTooDeep => "mais de 8 ramos abertos (NC-8)",
        Cause::OperandsMissing => "faltam linhas de operando depois deste código",
        Cause::BadPreset => "a pré-seleção vai de 0 a 2147483647 (NC-9, NC-15)",
        Cause::BadTimerOutput => "depois da pré-seleção deve vir 79XX, 77XX ou 84XX (NC-9)",
        Cause::BadOperand => "essa linha de operando está fora da sua faixa",
        Cause::PinUsedTwice => {
            "um pino é usado de dois modos: 05-08 e A 00-03, saída e PWM (NC-18)"
        }
        Cause::ProgramFull => "o programa não cabe na memória de programa a partir daqui (NC-10)",
        Cause::RunMemoryFull => "o programa não cabe na memória de execução a partir daqui (NC-10)",
        Cause::CannotKeep => "escreva KD e KC logo depois do 0, no máximo 16 (NC-21)",
        Cause::NoCard => "nenhum cartão responde; verifique o slot e os fios em D10 a D13",
        Cause::CardDead => "o cartão responde, mas não fica pronto; tente outro (MMC não serve)",
        Cause::CardReadError => "o cartão não pode ser lido; tente de novo ou tente outro",
        Cause::NoVolume => "o cartão não é FAT16 nem FAT32; formate-o",
        Cause::NoProgramFile => "não há PROGRAM.TXT na pasta raiz (será PROGRAM.TXT.TXT?)",
        Cause::VolumeDamaged => "a FAT do cartão está danificada; verifique ou formate o cartão",
        Cause::FileChanged => "a segunda leitura do cartão trouxe outro programa; use outro cartão",
        Cause::ScanTooLong => {
            "uma varredura levou mais de 110 ms; aperte o reset para tentar de novo"
        }
        Cause::ProgramDamaged => "o programa na memória de execução mudou; aperte o reset",
        Cause::StackOverflow => "a pilha alcançou a memória de execução; aperte o reset",
        Cause::SupplyLow => "a alimentação está abaixo de 4,3 V; use um cabo ou uma fonte melhor",
        Cause::NoStoredProgram => {
            "não há cartão com programa, e nenhum programa válido está guardado"
        }
        Cause::StoreFailed => "a memória de programa não conserva o que se grava nela",
        Cause::LabelTwice => "este rótulo aparece duas vezes (NC-19)",
        Cause::NoSuchLabel => "o programa não tem esse rótulo (NC-19)",
        Cause::LabelInRung => "um rótulo deve ficar no início de um degrau (NC-19)",
        Cause::JumpInBranch => {
            "nenhum desvio, retorno ou IF entre 40 e 41 ou depois de PSH (NC-19)"
        }
        Cause::TooManyJumps => "desvios demais para trás em uma varredura (NC-19)",
        Cause::NothingPushed => "nenhum valor está empilhado aqui (NC-22)",
        Cause::PushedTooDeep => "mais de 8 valores empilhados (NC-22)",
        Cause::ValueLeftPushed => "um valor ainda está empilhado onde o degrau termina (NC-22)",
        Cause::NotReal => "não são os bits de um número REAL finito (NC-23)",
        Cause::NoIf => "ELS ou END sem IF, ou um segundo ELS (NC-28)",
        Cause::IfTooDeep => "mais de 8 IFs abertos (NC-28)",
        Cause::IfLeftOpen => "este IF não tem END (NC-28)",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_translated_page_has_every_fault() {
        let page = include_str!("../../../../docs/numeric-code.pt-BR.md");
        for &cause in Cause::ALL {
            let row = format!("| {} | {} |", cause.number(), portuguese(cause));
            assert!(
                page.contains(&row),
                "docs/numeric-code.pt-BR.md has no {row}"
            );
        }
    }
}
