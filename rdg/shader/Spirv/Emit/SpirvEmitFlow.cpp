// Emits control flow: masks where lanes part, plain branches where they do not.
#include "SpirvEmitter.h"

#include "SpirvLimits.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

std::string FSpirvEmitter::MaskOf(uint32_t Label)
{
	const std::string Name = "m" + std::to_string(Label);
	if (Declared.insert(Name).second)
	{
		Declare("M", Name, 0, "(false)");
	}
	return Name;
}

bool FSpirvEmitter::IsDirectBreak(uint32_t To) const
{
	return !Loops.empty() && Module.GetBlock(Loops.back()).Merge == To && !Uniformity.IsDivergentLoop(Loops.back());
}

/** Some lanes that enter the region may not reach its end, while others do. A direct break takes all of them. Inside:
 *  labels that jumps may go to without leaving. */
bool FSpirvEmitter::EscapesFrom(
	const FStructRegion& Region, std::initializer_list<uint32_t> Inside, bool bInnerLoop) const
{
	return Region.bEnds || std::ranges::any_of(Region.Jumps,
							   [this, &Inside, bInnerLoop](const FStructJump& Jump)
							   {
								   const bool bStays =
									   Jump.bFallsThrough || std::ranges::find(Inside, Jump.To) != Inside.end();
								   return !bStays && (bInnerLoop || Jump.bInnerLoop || !IsDirectBreak(Jump.To));
							   });
}

bool FSpirvEmitter::Escapes(const FStructNode& Node) const
{
	const bool bLoop = Node.Kind == EStructNode::Loop;
	return std::ranges::any_of(Node.Regions,
		[this, &Node, bLoop](const FStructRegion& Region) {
			return EscapesFrom(Region, {Node.Merge, Node.Continue}, bLoop);
		});
}

void FSpirvEmitter::EmitRegion(const FStructRegion& Region, size_t First)
{
	const bool bCut = bInParts && !PartStart && Region.Weight > SpirvLimits::LinesPerPart;
	size_t Guards = 0;
	for (size_t i = First; i < Region.Nodes.size(); ++i)
	{
		const FStructNode& Node = Region.Nodes[i];
		const bool bConstruct =
			Node.Kind == EStructNode::If || Node.Kind == EStructNode::Switch || Node.Kind == EStructNode::Loop;
		const bool bGuard = bConstruct && i + 1 < Region.Nodes.size() && Escapes(Node);
		if (bCut)
		{
			SetPart(!bGuard && Node.Weight <= SpirvLimits::LinesPerPart && !Breaks(Node));
		}
		EmitNode(Node);
		if (bCut && NumLines - PartStart > SpirvLimits::LinesPerPart)
		{
			SetPart(false);
		}
		if (bGuard)
		{
			OpenScope(GuardRest);
			++Guards;
		}
	}
	if (bCut)
	{
		SetPart(false);
	}
	for (; Guards; --Guards)
	{
		CloseScope();
	}
}

/** The text of the node has a `break` out of it, which a function of its own could not have. */
bool FSpirvEmitter::Breaks(const FStructNode& Node) const
{
	return (Node.Kind == EStructNode::Edge && Node.bJump && IsDirectBreak(Node.To)) ||
		   std::ranges::any_of(Node.Regions,
			   [this](const FStructRegion& Region) {
				   return std::ranges::any_of(
					   Region.Jumps, [this](const FStructJump& Jump) { return IsDirectBreak(Jump.To); });
			   });
}

void FSpirvEmitter::EmitBlock(const FStructNode& Node)
{
	CurrentBlock = Node.Label;
	const bool bCut = bInParts && !PartStart && Node.Weight > SpirvLimits::LinesPerPart;
	for (const FSpirvInstruction& I : Module.GetBlock(Node.Label).Instructions)
	{
		if (bCut)
		{
			SetPart(true);
		}
		EmitInstruction(I);
		if (bCut && NumLines - PartStart > SpirvLimits::LinesPerPart)
		{
			SetPart(false);
		}
	}
	if (bCut)
	{
		SetPart(false);
	}
}

void FSpirvEmitter::EmitNode(const FStructNode& Node)
{
	switch (Node.Kind)
	{
	case EStructNode::Block:
		EmitBlock(Node);
		break;
	case EStructNode::Edge:
		EmitEdge(Node);
		break;
	case EStructNode::If:
		EmitIf(Node);
		break;
	case EStructNode::Switch:
		EmitSwitch(Node);
		break;
	case EStructNode::Loop:
		EmitLoop(Node);
		break;
	case EStructNode::Kill:
		if (Module.bQuads)
		{
			Line("Live = Live & !e;");
		}
		Line("e = M(false);"); // outputs are written by lanes that return
		break;
	case EStructNode::Return:
		EmitOutputs();
		Line("e = M(false);");
		break;
	}
}

void FSpirvEmitter::EmitEdge(const FStructNode& Node)
{
	EmitPhiCopies(Node.From, Node.To);
	if (!Node.bJump)
	{
		return;
	}
	if (IsDirectBreak(Node.To))
	{
		Line("break;");
		return;
	}
	Findings.MasksNeeded.insert(Node.To);
	const std::string Mask = MaskOf(Node.To);
	Line(Mask + " = " + Mask + " | e;");
	Line("e = M(false);");
}

/** The variables of a phi, which are declared when an edge first hands a value over. */
const std::vector<FEmitScalar>& FSpirvEmitter::DeclarePhi(const FSpirvInstruction& I, uint32_t Label)
{
	std::vector<FEmitScalar>& List = Values[I.Result];
	const bool bFirst = List.empty();
	for (uint32_t i = 0; bFirst && i < SizeOf(I.Result); ++i)
	{
		const bool bVarying = Uniformity.IsVarying(I.Result, i);
		const ESpirvType Kind = Module.GetScalarKind(I.Type, i);
		const std::string Name = "p" + Number(I.Result) + "_" + Number(i);
		Declare(TypeName(Kind, bVarying), Name, 0, "{}");
		// Declared at the top, but it belongs to the loops around its block: lanes that left them keep their value.
		const auto Around = Structure.Loops.find(Label);
		Locals.push_back({Name, 0, Around == Structure.Loops.end() ? std::vector<uint32_t>() : Around->second});
		List.push_back({Name, Kind, bVarying, int(Locals.size()) - 1, EEmitLevel::Pack});
	}
	return List;
}

std::vector<FSpirvEmitter::FPhiCopy> FSpirvEmitter::ListPhiCopies(uint32_t From, uint32_t To, EPhiCopies Which)
{
	std::vector<FPhiCopy> Copies;
	for (const FSpirvInstruction& I : Module.GetBlock(To).Instructions)
	{
		if (I.Op != OpPhi)
		{
			break;
		}
		uint32_t Value = 0;
		for (size_t k = 0; k < I.Operands.size(); k += 2)
		{
			Value = I.Operands[k + 1] == From ? I.Operands[k] : Value;
		}
		if (!Value)
		{
			Module.Fail("SPIR-V: a phi does not name the block that control comes from", &I);
		}
		const std::vector<FEmitScalar>& Targets = DeclarePhi(I, To);
		for (uint32_t i = 0; i < Targets.size(); ++i)
		{
			const FEmitScalar& Target = Targets[i];
			if (Which != EPhiCopies::All && Target.bVarying != (Which == EPhiCopies::Varying))
			{
				continue;
			}
			const FEmitScalar Incoming = Scalar(Value, i);
			const bool bMasked =
				Target.bVarying && (Uniformity.IsDivergentJoin(To) || Findings.KeptByLanes.count(Target.Text));
			const std::string Source = UseAs(Incoming, Target.Kind, Target.bVarying);
			if (Source != Target.Text)
			{
				Copies.push_back({Target.Text, Source, Incoming.Text, bMasked});
			}
		}
	}
	return Copies;
}

void FSpirvEmitter::EmitPhiCopies(uint32_t From, uint32_t To, EPhiCopies Which)
{
	std::vector<FPhiCopy> Copies = ListPhiCopies(From, To, Which);
	std::set<std::string> Targets;
	for (const FPhiCopy& Copy : Copies)
	{
		Targets.insert(Copy.Target);
	}
	// All sources are read before any target is written; only sources that are targets themselves need a copy.
	const bool bOverlap =
		std::ranges::any_of(Copies, [&Targets](const FPhiCopy& Copy) { return Targets.count(Copy.Read) != 0; });
	if (bOverlap)
	{
		OpenScope("");
		for (FPhiCopy& Copy : Copies)
		{
			const std::string Name = "t" + Copy.Target;
			Line("const auto " + Name + " = " + Copy.Source + ";");
			Copy.Source = Name;
		}
	}
	for (const FPhiCopy& Copy : Copies)
	{
		Line(Copy.bMasked ? "Assign(e, " + Copy.Target + ", " + Copy.Source + ");"
						  : Copy.Target + " = " + Copy.Source + ";");
	}
	if (bOverlap)
	{
		CloseScope();
	}
}

void FSpirvEmitter::EmitIf(const FStructNode& Node)
{
	SourceLine(Module.GetBlock(Node.Label).Terminator());
	const FEmitScalar Condition = Scalar(Node.Value, 0);
	const bool bWaits = Node.Merge && Findings.MasksNeeded.count(Node.Merge);
	const auto IsEmpty = [this](const FStructRegion& Region)
	{
		const FStructNode& Edge = Region.Nodes[0];
		const bool bPhis = Module.GetBlock(Edge.To).Instructions[0].Op == OpPhi;
		return Region.Nodes.size() == 1 && !Edge.bJump && !bPhis;
	};
	const bool bElse = !IsEmpty(Node.Regions[1]);
	if (bWaits)
	{
		Line(MaskOf(Node.Merge) + " = M(false);");
	}
	if (!Condition.bVarying)
	{
		OpenScope("if (" + Use(Condition) + ")");
		EmitRegion(Node.Regions[0]);
		CloseScope();
		if (bElse)
		{
			OpenScope("else");
			EmitRegion(Node.Regions[1]);
			CloseScope();
		}
	}
	else
	{
		const std::string Label = std::to_string(Node.Label);
		const bool bEscapes = Escapes(Node) || bWaits;
		// If all lanes come back, the mask before is the mask after; else the lanes at the end of each side are joined.
		const std::string Before = "s" + Label;
		const std::string Taken = "c" + Label;
		OpenScope("");
		Line("const M " + Before + " = e;");
		Line("const M " + Taken + " = " + Use(Condition) + ";");
		Line("e = " + Before + " & " + Taken + ";");
		if (!IsEmpty(Node.Regions[0]))
		{
			OpenScope(GuardRest);
			EmitRegion(Node.Regions[0]);
			CloseScope();
		}
		if (bElse || bEscapes)
		{
			if (bEscapes)
			{
				Line("const M f" + Label + " = e;");
			}
			Line("e = " + Before + " & !" + Taken + ";");
			if (bElse)
			{
				OpenScope(GuardRest);
				EmitRegion(Node.Regions[1]);
				CloseScope();
			}
		}
		Line(bEscapes ? "e = e | f" + Label + ";" : "e = " + Before + ";");
		CloseScope();
	}
	if (bWaits)
	{
		Line("e = e | " + MaskOf(Node.Merge) + ";");
	}
}

void FSpirvEmitter::EmitSwitch(const FStructNode& Node)
{
	SourceLine(Module.GetBlock(Node.Label).Terminator());
	const bool bWaits = Findings.MasksNeeded.count(Node.Merge) != 0;
	if (bWaits)
	{
		Line(MaskOf(Node.Merge) + " = M(false);");
	}
	if (Node.Cases.size() == 1)
	{
		// glslang's way to leave a block early: a switch with nothing but a default.
		EmitRegion(Node.Regions[0]);
	}
	else
	{
		const FEmitScalar Selector = Scalar(Node.Value, 0);
		const std::string Label = std::to_string(Node.Label);
		const auto Chosen = [&Label](size_t i)
		{
			return "k" + Label + "_" + std::to_string(i);
		};
		OpenScope("");
		std::string Taken = "M(false)";
		size_t Default = Node.Cases.size();
		for (size_t i = 0; i < Node.Cases.size(); ++i)
		{
			const FStructCase& Case = Node.Cases[i];
			if (Case.bDefault)
			{
				Default = i;
				continue;
			}
			std::string Condition;
			for (const uint32_t Value : Case.Values)
			{
				Condition += Condition.empty() ? "" : " || ";
				Condition += "(" + Use(Selector) + " == " + Literal(Selector.Kind, Value).Text + ")";
			}
			Line("const M " + Chosen(i) + " = e & M(" + Condition + ");");
			Taken += " | " + Chosen(i);
		}
		Line("const M " + Chosen(Default) + " = e & !(" + Taken + ");");
		for (const FStructCase& Case : Node.Cases)
		{
			if (Findings.MasksNeeded.count(Case.Label) && Case.Label != Node.Merge)
			{
				Line(MaskOf(Case.Label) + " = M(false);");
			}
		}
		Line("M f" + Label + "(false);"); // lanes at the end of a case
		for (size_t i = 0; i < Node.Cases.size(); ++i)
		{
			Line("e = " + Chosen(i) + ";");
			const bool bFallenInto =
				Findings.MasksNeeded.count(Node.Cases[i].Label) && Node.Cases[i].Label != Node.Merge;
			if (bFallenInto)
			{
				// Lanes that fall into the case have their phis already; those that chose it get them now.
				OpenScope(GuardRest);
				EmitPhiCopies(Node.Label, Node.Cases[i].Label);
				CloseScope();
				Line("e = e | " + MaskOf(Node.Cases[i].Label) + ";");
			}
			OpenScope(GuardRest);
			EmitRegion(Node.Regions[i], bFallenInto ? 1 : 0);
			CloseScope();
			Line("f" + Label + " = f" + Label + " | e;");
		}
		Line("e = f" + Label + ";");
		CloseScope();
	}
	if (bWaits)
	{
		Line("e = e | " + MaskOf(Node.Merge) + ";");
	}
}

void FSpirvEmitter::EmitTurn(const FStructNode& Node, bool bPacks)
{
	if (!IsCounted(Node))
	{
		return;
	}
	const FSpirvInstruction& Header = Module.GetBlock(Node.Label).Terminator();
	const int32_t* const Size = Reflection.Reflection.GroupSize;
	const std::string Thread = bPacks ? "P * N + FirstLane(e)" : "0";
	const auto InGroup = [&Thread](int32_t Before, int32_t Count)
	{
		return " + (" + Thread + ") / " + std::to_string(Before) + " % " + std::to_string(Count);
	};
	const std::string At = bGroups ? "X" + InGroup(1, Size[0]) + ", Y" + InGroup(Size[0], Size[1]) + ", Z" +
										 InGroup(Size[0] * Size[1], Size[2])
						   : Module.bQuads ? "X[FirstLane(e)], Y[FirstLane(e)], 0"
										   : "X0 + FirstLane(e), Y, Z";
	Line("if (__builtin_expect(++n" + std::to_string(Node.Label) + " > LoopTurns, 0)) EndLoop(Args, " +
		 QuoteForCpp(Module.Files[Header.File]) + ", " + std::to_string(Header.Line) + ", " + At + ");");
}

void FSpirvEmitter::EmitLoop(const FStructNode& Node)
{
	const FStructRegion& BodyRegion = Node.Regions[0];
	const FStructRegion& ContinueRegion = Node.Regions[1];
	const bool bMergeWaits = Findings.MasksNeeded.count(Node.Merge) != 0;
	const bool bContinueWaits = Node.Continue != Node.Label && Findings.MasksNeeded.count(Node.Continue) != 0;
	if (bMergeWaits)
	{
		Line(MaskOf(Node.Merge) + " = M(false);");
	}
	Loops.push_back(Node.Label);
	const bool bBodyLoses = EscapesFrom(BodyRegion, {Node.Continue}, false);
	const bool bContinueLoses = EscapesFrom(ContinueRegion, {Node.Label}, false);
	if (IsCounted(Node))
	{
		Line("uint32_t n" + std::to_string(Node.Label) + " = 0;");
	}
	OpenScope("for (;;)");
	if (bContinueWaits)
	{
		Line(MaskOf(Node.Continue) + " = M(false);");
	}
	OpenScope("");
	EmitRegion(BodyRegion);
	CloseScope();
	if (bContinueWaits)
	{
		Line("e = e | " + MaskOf(Node.Continue) + ";");
	}
	if (bBodyLoses || bContinueWaits)
	{
		Line("if (!AnyLane(e)) break;");
	}
	if (!ContinueRegion.Nodes.empty())
	{
		EmitRegion(ContinueRegion);
		if (bContinueLoses)
		{
			Line("if (!AnyLane(e)) break;");
		}
	}
	EmitTurn(Node, true);
	CloseScope();
	Loops.pop_back();
	if (bMergeWaits)
	{
		Line("e = e | " + MaskOf(Node.Merge) + ";");
	}
}

} // namespace Drydock
