// Emits shaders whose threads work together. A group is run from one barrier to the next by a loop over its packs:
//
//   for each group
//       for each pack { what stands before the barrier }     a segment
//       for each pack { what stands behind it }
//
// What a segment computes and another one needs is kept in an array with an element for each pack. Control flow around
// a barrier stands outside of the loops over packs, and must be the same for all threads of the group; values that are
// the same for the group are plain variables there. Inside of a segment everything is as in any other kernel. Source of
// the idea: Jaaskelainen et al., "pocl: A Performance-Portable OpenCL Implementation" (IJPP 2015), work-item loops.
#include "SpirvEmitter.h"

#include "SpirvGroups.h"
#include "SpirvLimits.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

std::set<std::string> FindNames(const std::string& Text)
{
	std::set<std::string> Names;
	for (size_t i = 0; i < Text.size();)
	{
		size_t End = i;
		while (End < Text.size() && IsWordCharacter(Text[End]))
		{
			++End;
		}
		if (End > i && !IsDigit(Text[i]))
		{
			Names.insert(Text.substr(i, End - i));
		}
		i = End > i ? End : i + 1;
	}
	return Names;
}

} // namespace

/** bAll: for packs without a running thread, too. */
void FSpirvEmitter::OpenSegment(bool bAll)
{
	if (bInSegment)
	{
		return;
	}
	bInSegment = true;
	Line("for (int32_t P = 0; P < NumPacks; ++P)");
	OpenScope("");
	Segments.push_back({Body.size(), 0, bAll, !Loops.empty()});
}

void FSpirvEmitter::CloseSegment()
{
	if (!bInSegment)
	{
		return;
	}
	for (; SegmentGuards; --SegmentGuards)
	{
		CloseScope();
	}
	Line("E[P] = e;");
	Segments.back().End = Body.size();
	CloseScope();
	bInSegment = false;
}

void FSpirvEmitter::EmitForAllPacks(const std::string& Statement)
{
	CloseSegment();
	OpenSegment(true);
	Line(Statement);
	CloseSegment();
}

/** The text of the node has a barrier, or a `break` out of a loop that has one. */
bool FSpirvEmitter::IsGroupNode(const FStructNode& Node) const
{
	return std::ranges::any_of(Node.Regions,
		[this, &Node](const FStructRegion& Region)
		{
			return FindBarrier(Module, Region) ||
				   (Node.Kind != EStructNode::Loop && std::ranges::any_of(Region.Jumps, [this](const FStructJump& Jump)
														  { return !Jump.bInnerLoop && IsDirectBreak(Jump.To); }));
		});
}

void FSpirvEmitter::FailBarrier(const FStructNode& Node, const std::string& What) const
{
	const FSpirvInstruction* Barrier = nullptr;
	for (const FStructRegion& Region : Node.Regions)
	{
		Barrier = Barrier ? Barrier : FindBarrier(Module, Region);
	}
	const int Line = Module.GetBlock(Node.Label).Terminator().Line;
	Module.Fail("a barrier (GroupMemoryBarrierWithGroupSync) " + What +
					(Line ? " (line " + std::to_string(Line) + ")" : std::string()) +
					": all threads of a group must come to it, or none",
		Barrier);
}

void FSpirvEmitter::EmitGroupRegion(const FStructRegion& Region)
{
	for (size_t i = 0; i < Region.Nodes.size(); ++i)
	{
		const FStructNode& Node = Region.Nodes[i];
		if (Node.Kind == EStructNode::Edge)
		{
			// Each pack runs a loop without barriers for itself, from its first turn on.
			const FStructNode* const Next = i + 1 < Region.Nodes.size() ? &Region.Nodes[i + 1] : nullptr;
			const bool bOwnLoop =
				Next && Next->Kind == EStructNode::Loop && Next->Label == Node.To && !IsGroupNode(*Next);
			EmitGroupEdge(Node, bOwnLoop);
		}
		else if (!IsGroupNode(Node))
		{
			OpenSegment(false);
			EmitNode(Node);
			if (bInSegment && i + 1 < Region.Nodes.size() && Escapes(Node))
			{
				OpenScope(GuardRest);
				++SegmentGuards;
			}
		}
		else
		{
			CloseSegment();
			SourceLine(Module.GetBlock(Node.Label).Terminator());
			Node.Kind == EStructNode::If       ? EmitGroupIf(Node)
			: Node.Kind == EStructNode::Switch ? EmitGroupSwitch(Node)
											   : EmitGroupLoop(Node);
		}
	}
	CloseSegment();
}

void FSpirvEmitter::EmitGroupEdge(const FStructNode& Node, bool bOwnLoop)
{
	OpenSegment(false);
	if (bOwnLoop)
	{
		EmitPhiCopies(Node.From, Node.To, EPhiCopies::All);
		return;
	}
	// Each pack has its own copies of what varies; what does not is copied once for all of them, and last.
	EmitPhiCopies(Node.From, Node.To, EPhiCopies::Varying);
	if (Node.bJump && !IsDirectBreak(Node.To))
	{
		Findings.MasksNeeded.insert(Node.To);
		const std::string Mask = MaskOf(Node.To);
		Line(Mask + " = " + Mask + " | e;");
		Line("e = M(false);");
	}
	const bool bBreaks = Node.bJump && IsDirectBreak(Node.To);
	if (!bBreaks && !HasUniformPhi(Node.To))
	{
		return; // the wave goes on to its next barrier before another one comes
	}
	CloseSegment();
	EmitPhiCopies(Node.From, Node.To, EPhiCopies::Uniform);
	if (bBreaks)
	{
		Line("break;");
	}
}

bool FSpirvEmitter::HasUniformPhi(uint32_t Label)
{
	for (const FSpirvInstruction& I : Module.GetBlock(Label).Instructions)
	{
		for (uint32_t i = 0; I.Op == OpPhi && i < SizeOf(I.Result); ++i)
		{
			if (!Uniformity.IsVarying(I.Result, i))
			{
				return true;
			}
		}
	}
	return false;
}

void FSpirvEmitter::EmitGroupIf(const FStructNode& Node)
{
	const FEmitScalar Condition = Scalar(Node.Value, 0);
	if (Condition.bVarying)
	{
		FailBarrier(Node, "under a condition that is not known to be the same for all threads of the group");
	}
	const bool bWaits = Node.Merge && Findings.MasksNeeded.count(Node.Merge);
	if (bWaits)
	{
		EmitForAllPacks(MaskOf(Node.Merge) + " = M(false);");
	}
	OpenScope("if (" + Use(Condition) + ")");
	EmitGroupRegion(Node.Regions[0]);
	CloseScope();
	OpenScope("else");
	EmitGroupRegion(Node.Regions[1]);
	CloseScope();
	if (bWaits)
	{
		EmitForAllPacks("e = e | " + MaskOf(Node.Merge) + ";");
	}
}

void FSpirvEmitter::EmitGroupSwitch(const FStructNode& Node)
{
	if (Node.Cases.size() != 1)
	{
		FailBarrier(Node, "in a case of a switch, which the CPU tier does not do; write it with if");
	}
	// glslang's way to leave a block early: a switch with nothing but a default.
	const bool bWaits = Findings.MasksNeeded.count(Node.Merge) != 0;
	if (bWaits)
	{
		EmitForAllPacks(MaskOf(Node.Merge) + " = M(false);");
	}
	EmitGroupRegion(Node.Regions[0]);
	if (bWaits)
	{
		EmitForAllPacks("e = e | " + MaskOf(Node.Merge) + ";");
	}
}

void FSpirvEmitter::EmitGroupLoop(const FStructNode& Node)
{
	if (Uniformity.IsDivergentLoop(Node.Label))
	{
		FailBarrier(Node, "in a loop that threads of a group may leave at different times");
	}
	const bool bMergeWaits = Findings.MasksNeeded.count(Node.Merge) != 0;
	const bool bContinueWaits = Node.Continue != Node.Label && Findings.MasksNeeded.count(Node.Continue) != 0;
	if (bMergeWaits)
	{
		EmitForAllPacks(MaskOf(Node.Merge) + " = M(false);");
	}
	Loops.push_back(Node.Label);
	if (IsCounted(Node))
	{
		Line("uint32_t n" + std::to_string(Node.Label) + " = 0;");
	}
	OpenScope("for (;;)");
	Line("if (!AnyPack(E)) break;"); // what nobody computes anew would never end the loop
	if (bContinueWaits)
	{
		EmitForAllPacks(MaskOf(Node.Continue) + " = M(false);");
	}
	OpenScope("");
	EmitGroupRegion(Node.Regions[0]);
	CloseScope();
	if (bContinueWaits)
	{
		EmitForAllPacks("e = e | " + MaskOf(Node.Continue) + ";");
	}
	EmitGroupRegion(Node.Regions[1]);
	EmitTurn(Node, false);
	CloseScope();
	Loops.pop_back();
	if (bMergeWaits)
	{
		EmitForAllPacks("e = e | " + MaskOf(Node.Merge) + ";");
	}
}

std::vector<FEmitScalar> FSpirvEmitter::LoadGroupInput(const FSpirvVariable& Variable)
{
	const int32_t* const Size = Reflection.Reflection.GroupSize;
	const auto Number = [](int32_t Value)
	{
		return std::to_string(Value) + "u";
	};
	const auto Local = [&](int Axis) -> std::string
	{
		const int32_t Before = Axis == 0 ? 1 : Axis == 1 ? Size[0] : Size[0] * Size[1];
		const int32_t Behind = Axis == 0 ? Size[1] * Size[2] : Axis == 1 ? Size[2] : 1;
		std::string Text = "AsUint(T)";
		Text = Before == 1 ? Text : "IntDivide(" + Text + ", " + Number(Before) + ")";
		return Behind == 1 ? Text : "IntRemainder(" + Text + ", " + Number(Size[Axis]) + ")";
	};
	const char* const Origin[] = {"X", "Y", "Z"};
	std::vector<FEmitScalar> Result;
	switch (Variable.BuiltIn)
	{
	case BuiltInLocalInvocationIndex:
		return {{"AsUint(T)", ESpirvType::Uint, true, -1}};
	case BuiltInSubgroupSize:
		return {{"uint32_t(N)", ESpirvType::Uint, false, -1}};
	case BuiltInSubgroupLocalInvocationId:
		return {{"AsUint(LaneIndex<N>())", ESpirvType::Uint, true, -1}};
	case BuiltInWorkgroupId:
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			Result.push_back({std::string("uint32_t(") + Origin[Axis] + ") / " + Number(Size[Axis]), ESpirvType::Uint,
				false, -1, EEmitLevel::Row});
		}
		return Result;
	case BuiltInLocalInvocationId:
	case BuiltInGlobalInvocationId:
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			const bool bGlobal = Variable.BuiltIn == BuiltInGlobalInvocationId;
			const std::string First = std::string("uint32_t(") + Origin[Axis] + ")";
			if (Size[Axis] == 1)
			{
				Result.push_back({bGlobal ? First : "0u", ESpirvType::Uint, false, -1, EEmitLevel::Row});
				continue;
			}
			Result.push_back(
				{(bGlobal ? "U(" + First + ") + " : std::string()) + Local(Axis), ESpirvType::Uint, true, -1});
		}
		return Result;
	default:
		Module.Fail("input '" + Variable.Name + "' is not one of a compute shader");
	}
}

/** Declares each name in the one segment that needs it, or else in the group. */
std::string FSpirvEmitter::PlaceDeclarations(std::string& InitialText)
{
	std::vector<std::set<std::string>> NamesOf;
	std::string Outside = Body;
	for (size_t i = Segments.size(); i-- > 0;)
	{
		Outside.erase(Segments[i].Begin, Segments[i].End - Segments[i].Begin);
	}
	for (const FSegment& Segment : Segments)
	{
		NamesOf.push_back(FindNames(Body.substr(Segment.Begin, Segment.End - Segment.Begin)));
	}
	const std::set<std::string> OutsideNames = FindNames(Outside);
	const int32_t* const Size = Reflection.Reflection.GroupSize;
	const uint64_t NumThreads = uint64_t(Size[0]) * uint64_t(Size[1]) * uint64_t(Size[2]);
	std::vector<std::string> Prologues;
	for (const FSegment& Segment : Segments)
	{
		Prologues.push_back(std::string("M e = E[P];\n") + (Segment.bAll ? "" : "if (!AnyLane(e)) continue;\n") +
							"const I T = I(P * N) + LaneIndex<N>();\n(void)T;\n");
	}
	std::string GroupText;
	uint64_t Bytes = 0;
	for (const FDeclaration& D : Declarations)
	{
		const std::string Array = D.Size ? "[" + std::to_string(D.Size) + "]" : std::string();
		std::vector<size_t> Users;
		for (size_t i = 0; i < NamesOf.size(); ++i)
		{
			if (NamesOf[i].count(D.Name))
			{
				Users.push_back(i);
			}
		}
		const bool bWide = D.Type.back() == '>';           // TLong<N> and its like
		const bool bVarying = D.Type.size() == 1 || bWide; // R, I, U, M
		const bool bStays = D.bVariable && !Users.empty() && Segments[Users[0]].bInLoop;
		if (Users.size() == 1 && !OutsideNames.count(D.Name) && !bStays)
		{
			Prologues[Users[0]] += D.Type + " " + D.Name + Array + D.Initial + ";\n";
			continue;
		}
		if (!bVarying)
		{
			GroupText += "\t" + D.Type + " " + D.Name + Array + D.Initial + ";\n";
			continue;
		}
		Bytes += NumThreads * (bWide ? 8 : 4) * std::max(1u, D.Size);
		GroupText += "\t" + D.Type + " C" + D.Name + "[NumPacks]" + Array + ";\n";
		if (D.bVariable || D.Type == "M")
		{
			const std::string Value = "const " + D.Type + " First" + Array + D.Initial + ";";
			InitialText += "\t{ " + Value + " for (auto& One : C" + D.Name +
						   ") __builtin_memcpy(&One, &First, sizeof(First)); }\n";
		}
		for (const size_t User : Users)
		{
			Prologues[User] += "auto& " + D.Name + " = C" + D.Name + "[P];\n";
		}
	}
	if (Bytes > SpirvLimits::MaxGroupBytes)
	{
		Module.FailLimit(SpirvLimits::MaxGroupBytes, "bytes that threads of a group keep over barriers",
			"use fewer threads, smaller arrays, or groupshared memory");
	}
	for (size_t i = Segments.size(); i-- > 0;)
	{
		Body.insert(Segments[i].Begin, Prologues[i]);
	}
	return GroupText;
}

std::string FSpirvEmitter::EmitGroupRun()
{
	DeclareVariables();
	EmitGroupRegion(Structure.Root);
	const int32_t* const Size = Reflection.Reflection.GroupSize;
	std::string InitialText;
	const std::string GroupText = PlaceDeclarations(InitialText);
	const std::string Count = std::to_string(Size[0] * Size[1] * Size[2]);
	const auto Loop = [&Size](const std::string& Axis, int Index)
	{
		return "\tfor (int32_t " + Axis + " = Tile.Min" + Axis + "; " + Axis + " < Tile.Max" + Axis + "; " + Axis +
			   " += " + std::to_string(Size[Index]) + ")\n";
	};
	return "\tconst uint32_t LoopTurns = GetLoopTurns(Args);\n\t(void)LoopTurns;\n" + Handles + TileText +
		   "\tconstexpr int32_t NumPacks = (" + Count + " + N - 1) / N;\n" + Loop("Z", 2) + Loop("Y", 1) +
		   Loop("X", 0) + "\t{\n" + RowText + SharedText + GroupText + InitialText +
		   "\tM E[NumPacks];\n"
		   "\tfor (int32_t P = 0; P < NumPacks; ++P) E[P] = I(P * N) + LaneIndex<N>() < I(" +
		   Count + ");\n" + Body + "\t}\n";
}

} // namespace Drydock
