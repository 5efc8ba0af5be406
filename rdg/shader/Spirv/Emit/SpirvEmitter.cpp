// Emits the kernel around the shader's code, and the scalars that it is made of.
#include "SpirvEmitter.h"

#include "SpirvGroups.h"
#include "SpirvLimits.h"
#include "SpirvScalarMath.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

FSpirvEmitter::FSpirvEmitter(const FSpirvEmitInput& Input, const FSpirvDependence& InDependence, FFindings InFindings)
	: Module(Input.Module)
	, Structure(Input.Structure)
	, Uniformity(Input.Uniformity)
	, Dependence(InDependence)
	, Reflection(Input.Reflection)
	, Tables(FindConstantTables(Input.Module))
	, Turns(Input.Module)
	, Findings(std::move(InFindings))
	, GroupUse(FindGroupUse(Input.Module))
	, bGroups(GroupUse.bGroups)
{
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Result)
			{
				Definitions[I.Result] = &I;
			}
			for (const uint32_t Operand : I.Operands) // a literal that looks like an id costs a copy at worst
			{
				++NumUses[Operand];
			}
		}
	}
}

void FSpirvEmitter::OpenScope(const std::string& Head)
{
	if (!Head.empty())
	{
		Line(Head);
	}
	Line("{");
	++Indent;
	Scopes.push_back(NumScopes++);
}

void FSpirvEmitter::CloseScope(const char* Tail)
{
	Scopes.pop_back();
	--Indent;
	Line(Tail);
}

void FSpirvEmitter::SetPart(bool bOpen)
{
	if (bOpen && !PartStart)
	{
		OpenScope("[&]() __attribute__((noinline))");
		PartStart = NumLines;
	}
	else if (!bOpen && PartStart)
	{
		CloseScope("}();");
		PartStart = 0;
	}
}

void FSpirvEmitter::Line(const std::string& Text)
{
	if (++NumLines > SpirvLimits::MaxLines)
	{
		Module.FailLimit(SpirvLimits::MaxLines, "lines of C++ when it is translated",
			"do less in one pass, or put large arrays into a buffer", Current);
	}
	const EEmitLevel Level = GetLevel();
	std::string& Out = Level == EEmitLevel::Tile ? TileText : Level == EEmitLevel::Row ? RowText : Body;
	Out.append(Level == EEmitLevel::Pack ? size_t(Indent) : 1, '\t');
	Out += Text;
	Out += '\n';
}

void FSpirvEmitter::SourceLine(const FSpirvInstruction& I)
{
	if (I.Line && (I.File != LastFile || I.Line != LastLine))
	{
		LastFile = I.File;
		LastLine = I.Line;
		Body += "#line " + std::to_string(I.Line) + " " + QuoteForCpp(Module.Files[I.File]) + "\n";
	}
}

std::string FSpirvEmitter::TypeName(ESpirvType Kind, bool bVarying) const
{
	return Kind == ESpirvType::Float || Kind == ESpirvType::Half    ? (bVarying ? "R" : "Real")
		   : Kind == ESpirvType::Int || Kind == ESpirvType::Short   ? (bVarying ? "I" : "int32_t")
		   : Kind == ESpirvType::Uint || Kind == ESpirvType::Ushort ? (bVarying ? "U" : "uint32_t")
		   : Kind == ESpirvType::Double                             ? (bVarying ? "TReal<double, N>" : "double")
		   : Kind == ESpirvType::Long                               ? (bVarying ? "TLong<N>" : "int64_t")
		   : Kind == ESpirvType::Ulong                              ? (bVarying ? "TUlong<N>" : "uint64_t")
		   : bVarying                                               ? "M"
																	: "bool";
}

namespace
{

/** %.*g, which may print a whole number. */
std::string FormatReal(double Value, int Digits, const char* Type, const char* Suffix)
{
	char Text[64];
	if (!std::isfinite(Value))
	{
		std::snprintf(Text, sizeof(Text), "%s(%s)", Type,
			Value != Value ? "__builtin_nanf(\"\")"
			: Value > 0    ? "__builtin_inff()"
						   : "-__builtin_inff()");
		return Text;
	}
	std::snprintf(Text, sizeof(Text), "%.*g", Digits, Value);
	const bool bWhole = !std::strpbrk(Text, ".e");
	return std::string(Type) + "(" + Text + (bWhole ? ".0" : "") + Suffix + ")";
}

} // namespace

FEmitScalar FSpirvEmitter::Literal(ESpirvType Kind, uint64_t Bits) const
{
	FEmitScalar Result;
	Result.Kind = Kind;
	const uint64_t Word = FromSpirvMemory<float>(Kind, Bits);
	switch (Kind)
	{
	case ESpirvType::Float:
	case ESpirvType::Half:
		Result.Text = FormatReal(double(ToSpirvReal<float>(Word)), 9, "Real", "f");
		break;
	case ESpirvType::Double:
		Result.Text = FormatReal(ToSpirvReal<double>(Word), 17, "double", "");
		break;
	case ESpirvType::Int:
	case ESpirvType::Short:
		Result.Text = Word == 0x80000000u ? "(-2147483647 - 1)" : "int32_t(" + std::to_string(int32_t(Word)) + ")";
		break;
	case ESpirvType::Uint:
	case ESpirvType::Ushort:
		Result.Text = std::to_string(Word) + "u";
		break;
	case ESpirvType::Long:
	case ESpirvType::Ulong:
		Result.Text = std::string(Kind == ESpirvType::Long ? "int64_t(" : "uint64_t(") + std::to_string(Word) + "ull)";
		break;
	default:
		Result.Text = Bits ? "true" : "false";
		break;
	}
	return Result;
}

FEmitScalar FSpirvEmitter::Scalar(uint32_t Value, uint32_t Index)
{
	if (const FSpirvConstant* Constant = Module.FindConstant(Value))
	{
		if (Index >= Constant->Scalars.size())
		{
			Module.Fail("SPIR-V: a constant has no scalar " + std::to_string(Index));
		}
		return Literal(Module.GetScalarKind(Constant->Type, Index), Constant->Scalars[Index]);
	}
	const auto Found = Values.find(Value);
	if (Found == Values.end() || Index >= Found->second.size())
	{
		Module.Fail("SPIR-V: value " + std::to_string(Value) + " is used before it is defined");
	}
	return Found->second[Index];
}

std::string FSpirvEmitter::Use(const FEmitScalar& S)
{
	OperandLevel = std::max(OperandLevel, S.Level);
	if (S.Local >= 0)
	{
		const FLocal& Local = Locals[size_t(S.Local)];
		if (std::find(Scopes.begin(), Scopes.end(), Local.Scope) == Scopes.end())
		{
			Findings.Hoisted.insert(Local.Name);
		}
		for (const uint32_t Loop : Local.Loops)
		{
			const bool bLeft = std::find(Loops.begin(), Loops.end(), Loop) == Loops.end();
			if (bLeft && Uniformity.IsDivergentLoop(Loop))
			{
				Findings.KeptByLanes.insert(Local.Name);
			}
		}
	}
	return S.Text;
}

std::string FSpirvEmitter::UseAs(const FEmitScalar& S, ESpirvType Kind, bool bVarying)
{
	std::string Text = Use(S);
	if (S.Kind != Kind && Kind != ESpirvType::None)
	{
		// SPIR-V lets signed and unsigned operands mix; the bits are what counts.
		switch (Kind)
		{
		case ESpirvType::Int:
			Text = "AsInt(" + Text + ")";
			break;
		case ESpirvType::Uint:
			Text = "AsUint(" + Text + ")";
			break;
		case ESpirvType::Short:
			Text = "WrapShort(" + Text + ")";
			break;
		case ESpirvType::Ushort:
			Text = "WrapUshort(" + Text + ")";
			break;
		case ESpirvType::Long:
			Text = "AsLong(" + Text + ")";
			break;
		case ESpirvType::Ulong:
			Text = "AsUlong(" + Text + ")";
			break;
		default:
			Text = "(" + Text + ")";
			break;
		}
	}
	if (bVarying && !S.bVarying)
	{
		Text = TypeName(Kind == ESpirvType::None ? S.Kind : Kind, true) + "(" + Text + ")";
	}
	return Text;
}

void FSpirvEmitter::Define(uint32_t Value, uint32_t Index, const FEmitScalar& Expression)
{
	const bool bVarying = Uniformity.IsVarying(Value, Index);
	const std::string Name = "v" + std::to_string(Value) + "_" + std::to_string(Index);
	const ESpirvType Kind = Module.GetScalarKind(Module.GetValueTypeId(Value), Index);
	std::string Text = UseAs(Expression, Kind, false);
	if (GetSpirvBytes(Kind) == 2 && Current && !MovesSpirvNumbers(Current->Op))
	{
		Text = (Kind == ESpirvType::Half       ? "RoundHalf("
				   : Kind == ESpirvType::Short ? "WrapShort("
											   : "WrapUshort(") +
			   Text + ")";
	}
	FEmitScalar Result;
	Result.Text = Name;
	Result.Kind = Kind;
	Result.bVarying = bVarying;
	OperandLevel = bVarying ? EEmitLevel::Pack : OperandLevel;
	Result.Level = GetLevel();
	if (Result.Level == EEmitLevel::Pack)
	{
		Result.Local = int(Locals.size());
		Locals.push_back({Name, Scopes.back(), Loops});
	}
	if (Result.Level == EEmitLevel::Pack && Findings.Hoisted.count(Name))
	{
		Declare(TypeName(Kind, bVarying), Name, 0, "{}");
		Line(bVarying && Findings.KeptByLanes.count(Name) ? "Assign(e, " + Name + ", " + Text + ");"
														  : Name + " = " + Text + ";");
	}
	else
	{
		Line("const " + TypeName(Kind, bVarying) + " " + Name + " = " + Text + ";");
	}
	std::vector<FEmitScalar>& List = Values[Value];
	List.resize(std::max<size_t>(List.size(), Index + 1));
	List[Index] = Result;
}

/** The operation has no effect, and reads nothing but operands, constants, and the pixel's place. */
bool FSpirvEmitter::IsMovable(const FSpirvInstruction& I) const
{
	if (bInParts)
	{
		return false; // what moves would be one long function again
	}
	switch (I.Op)
	{
	case OpLoad:
	{
		const FSpirvPlace Place = Resolve(I.Operands[0]);
		const uint32_t Storage = Place.Variable->Storage;
		return Storage == StorageInput || (Place.bBytes && !Module.GetType(Place.Variable->Type).bBufferBlock);
	}
	case OpExtInst:
		return I.Operands[1] != ExtModf;
	case OpArrayLength:
	case OpImageQuerySize:
	case OpImageQuerySizeLod:
	case OpImageQueryLevels:
		return true;
	default:
		return I.Result && (I.Op < OpSampledImage || I.Op > OpImageRead) && I.Op != OpFunctionCall &&
			   !IsSpirvAtomic(I.Op) && !IsSpirvWave(I.Op) && !IsSpirvDerivative(I.Op);
	}
}

std::string FSpirvEmitter::EmitRun()
{
	if (bGroups)
	{
		return EmitGroupRun();
	}
	bInParts = Structure.Root.Weight > SpirvLimits::MaxLinesUncut;
	DeclareVariables();
	EmitRegion(Structure.Root);
	if (Module.bQuads)
	{
		return EmitQuadRun();
	}
	if (NumTaps)
	{
		Handles += "\tFKernelTap Taps[" + std::to_string(NumTaps) + "];\n\tconst bool bStill = " + StillText() +
				   ";\n\tForgetTaps(Taps);\n";
	}
	std::string Declared;
	for (const FDeclaration& D : Declarations)
	{
		Declared += "\t" + D.Type + " " + D.Name + (D.Size ? "[" + std::to_string(D.Size) + "]" : std::string()) +
					D.Initial + ";\n";
	}
	return "\tconst uint32_t LoopTurns = GetLoopTurns(Args);\n\t(void)LoopTurns;\n" + Handles + TileText +
		   "\tfor (int32_t Z = Tile.MinZ; Z < Tile.MaxZ; ++Z)\n"
		   "\tfor (int32_t Y = Tile.MinY; Y < Tile.MaxY; ++Y)\n\t{\n" +
		   RowText +
		   "\tfor (int32_t X0 = Tile.MinX; X0 < Tile.MaxX; X0 += N)\n\t{\n"
		   "\tM e = LaneIndex<N>() < I(Tile.MaxX - X0);\n"
		   "\tconst I X = I(X0) + LaneIndex<N>();\n\t(void)X;\n" +
		   Declared + Body + "\t}\n\t}\n";
}

namespace
{

/** Some number has 16 or 64 bits. */
bool UsesWideTypes(const FSpirvModule& Module)
{
	return std::any_of(Module.Types.begin(), Module.Types.end(),
		[](const auto& Type) { return IsSpirvScalar(Type.second.Kind) && GetSpirvBytes(Type.second.Kind) != 4; });
}

} // namespace

std::string EmitKernel(const FSpirvEmitInput& Input, const std::string& Title)
{
	if (Input.Reflection.Reflection.Stage == EShaderStage::Vertex)
	{
		Input.Module.Fail("a vertex shader has no kernel");
	}
	// The number of passes is bounded: what one finds can only grow.
	FSpirvEmitter::FFindings Findings;
	const FSpirvDependence Dependence = AnalyzeDependence(Input.Module, Input.Structure);
	for (int Pass = 0;; ++Pass)
	{
		FSpirvEmitter Emitter(Input, Dependence, Findings);
		const std::string Run = Emitter.EmitRun();
		const FSpirvEmitter::FFindings& Found = Emitter.GetFindings();
		const bool bSettled = Found.Hoisted.size() == Findings.Hoisted.size() &&
							  Found.KeptByLanes.size() == Findings.KeptByLanes.size() &&
							  Found.MasksNeeded.size() == Findings.MasksNeeded.size();
		if (!bSettled && Pass < 8)
		{
			Findings = Found;
			continue;
		}
		return "// Generated by drydock from " + QuoteForCpp(Title) +
			   ".\n"
			   "#include \"KernelSupport.h\"\n" +
			   (UsesWideTypes(Input.Module) ? "#include \"LanesWideTypes.h\"\n\n" : "\n") +
			   "namespace\n{\n\n"
			   "using namespace Drydock;\n"
			   "using namespace Drydock::Lanes;\n"
			   "constexpr int N = " +
			   (FindGroupUse(Input.Module).bWaves ? std::to_string(Input.WaveSize)
				   : Input.Module.bQuads          ? "DRYDOCK_LANES < 4 ? 4 : DRYDOCK_LANES"
												  : "DRYDOCK_LANES") +
			   ";\n"
			   "using Real = DRYDOCK_REAL;\n"
			   "using R = TReal<Real, N>;\n"
			   "using I = TInt<N>;\n"
			   "using U = TUint<N>;\n"
			   "using M = TMask<N>;\n\n" +
			   Emitter.GetTables() + "\nvoid Run(const FKernelArgs& Args, const FKernelTile& Tile)\n{\n" + Run +
			   Emitter.GetEnd() +
			   "}\n\n"
			   "} // namespace\n\n"
			   "extern \"C\"\n{\n"
			   "extern const __attribute__((visibility(\"default\"))) Drydock::FKernelModule DrydockShaderKernel;\n"
			   "const Drydock::FKernelModule DrydockShaderKernel = {Drydock::GShaderKernelVersion, DRYDOCK_LANES, "
			   "sizeof(Real), "
			   "&Run};\n"
			   "}\n";
	}
}

} // namespace Drydock
