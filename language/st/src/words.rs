//! The keywords of Structured Text and SCL.

macro_rules! keywords {
    ($($name:ident $written:literal;)*) => {
        /// A keyword, or none.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum Keyword { None, $($name,)* }

        impl Keyword {
            /// All of them.
            pub const ALL: &'static [Keyword] = &[$(Keyword::$name,)*];

            /// As it is written.
            pub fn name(self) -> &'static str {
                match self {
                    Keyword::None => "",
                    $(Keyword::$name => $written,)*
                }
            }

            fn of_upper(upper: &str) -> Keyword {
                match upper {
                    $($written => Keyword::$name,)*
                    _ => Keyword::None,
                }
            }
        }
    };
}

keywords! {
    And "AND"; Array "ARRAY"; At "AT"; Begin "BEGIN"; By "BY"; Case "CASE"; Configuration "CONFIGURATION";
    Constant "CONSTANT"; Continue "CONTINUE"; DataBlock "DATA_BLOCK"; Do "DO"; Else "ELSE"; Elsif "ELSIF";
    EndAction "END_ACTION"; EndCase "END_CASE"; EndConfiguration "END_CONFIGURATION"; EndFor "END_FOR"; EndFunction "END_FUNCTION";
    EndFunctionBlock "END_FUNCTION_BLOCK"; EndIf "END_IF"; EndOrganizationBlock "END_ORGANIZATION_BLOCK";
    EndProgram "END_PROGRAM"; EndRegion "END_REGION"; EndRepeat "END_REPEAT"; EndStep "END_STEP";
    EndStruct "END_STRUCT"; EndTransition "END_TRANSITION"; EndType "END_TYPE"; EndVar "END_VAR"; EndWhile "END_WHILE"; Exit "EXIT"; False "FALSE"; For "FOR";
    Function "FUNCTION"; FunctionBlock "FUNCTION_BLOCK"; Goto "GOTO"; If "IF"; InitialStep "INITIAL_STEP"; Mod "MOD"; NonRetain "NON_RETAIN";
    Not "NOT"; Of "OF"; Or "OR"; OrganizationBlock "ORGANIZATION_BLOCK"; Persistent "PERSISTENT";
    Program "PROGRAM"; Region "REGION"; Repeat "REPEAT"; Retain "RETAIN"; Return "RETURN"; Struct "STRUCT";
    Then "THEN"; To "TO"; True "TRUE"; Type "TYPE"; Until "UNTIL"; Var "VAR"; VarAccess "VAR_ACCESS";
    VarConfig "VAR_CONFIG"; VarExternal "VAR_EXTERNAL"; VarGlobal "VAR_GLOBAL"; VarInOut "VAR_IN_OUT";
    VarInput "VAR_INPUT"; VarOutput "VAR_OUTPUT"; VarTemp "VAR_TEMP"; While "WHILE"; Xor "XOR";
}

impl Keyword {
    /// The keyword with this spelling, in letters of any case.
    pub fn of(word: &str) -> Keyword {
        // The longest has 22 letters.
        let mut room = [0; 24];
        let Some(upper) = room.get_mut(..word.len()) else {
            return Keyword::None;
        };
        upper.copy_from_slice(word.as_bytes());
        upper.make_ascii_uppercase();
        std::str::from_utf8(upper).map_or(Keyword::None, Keyword::of_upper)
    }

    /// Whether it begins a section of variables.
    pub fn is_section(self) -> bool {
        use Keyword::*;
        matches!(
            self,
            Var | VarInput
                | VarOutput
                | VarInOut
                | VarTemp
                | VarGlobal
                | VarExternal
                | VarAccess
                | VarConfig
        )
    }

    /// Whether it ends a unit.
    pub fn ends_unit(self) -> bool {
        use Keyword::*;
        matches!(
            self,
            EndProgram | EndFunction | EndFunctionBlock | EndOrganizationBlock
        )
    }

    /// Whether it ends a part of a chart.
    pub fn ends_part_of_chart(self) -> bool {
        use Keyword::*;
        matches!(self, EndStep | EndTransition | EndAction)
    }

    /// Whether it begins a unit, or a declaration outside units.
    pub fn begins_unit(self) -> bool {
        use Keyword::*;
        matches!(
            self,
            Program
                | Function
                | FunctionBlock
                | OrganizationBlock
                | Configuration
                | Type
                | DataBlock
        )
    }

    /// Whether it ends a part of a statement, or the statement.
    pub fn ends_part(self) -> bool {
        use Keyword::*;
        matches!(
            self,
            EndIf | EndFor | EndWhile | EndRepeat | EndCase | Until | Else | Elsif
        )
    }

    /// Whether it begins a statement.
    pub fn begins_statement(self) -> bool {
        use Keyword::*;
        matches!(
            self,
            If | For | While | Repeat | Case | Exit | Return | Continue
        )
    }
}

/// The keyword meant by a spelling, in upper case, that comes from another language or a slip.
pub(super) fn meant(upper: &str) -> Keyword {
    use Keyword::*;
    match upper {
        "ELSEIF" | "ELIF" | "ELSE_IF" | "ELIFS" | "ELSEIFS" | "ELSF" => Elsif,
        "ENDIF" | "FI" | "END_IFS" => EndIf,
        "ENDWHILE" | "WEND" => EndWhile,
        "ENDFOR" | "NEXT" => EndFor,
        "ENDCASE" | "ESAC" => EndCase,
        "ENDREPEAT" => EndRepeat,
        "ENDVAR" => EndVar,
        "ENDPROGRAM" | "END_PROG" => EndProgram,
        "ENDFUNCTION" => EndFunction,
        "ENDFUNCTIONBLOCK" | "END_FUNCTIONBLOCK" | "ENDFUNCTION_BLOCK" => EndFunctionBlock,
        "ENDSTRUCT" => EndStruct,
        "ENDTYPE" => EndType,
        "BREAK" => Exit,
        "FUNCTIONBLOCK" => FunctionBlock,
        "ENDSTEP" => EndStep,
        "ENDTRANSITION" | "END_TRANS" => EndTransition,
        "ENDACTION" => EndAction,
        "INITIALSTEP" | "INIT_STEP" => InitialStep,
        "SWITCH" => Case,
        "VAR_IN" | "VARINPUT" | "VAR_INPUTS" => VarInput,
        "VAR_OUT" | "VAROUTPUT" | "VAR_OUTPUTS" => VarOutput,
        "VAR_INOUT" => VarInOut,
        "GLOBAL_VAR" | "VARGLOBAL" => VarGlobal,
        _ => None,
    }
}
