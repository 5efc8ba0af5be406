// Writes random HLSL programs, statement by statement.
#include "ProgramGenerator.h"

namespace Drydock::Test
{

// clang-format off
std::string FProgramGenerator::Float(int Depth)
{
	if (Depth <= 0 || Chance(20))
	{
		return Pick({"f0", "f1", "f2", "x", "v0.x", "v1.w", "UniformFloat", "0.5", "-1.25", "3.0", "0.0", "Input.z"});
	}
	switch (Below(14))
	{
	case 0: return "(" + Float(Depth - 1) + " + " + Float(Depth - 1) + ")";
	case 1: return "(" + Float(Depth - 1) + " - " + Float(Depth - 1) + ")";
	case 2: return "(" + Float(Depth - 1) + " * " + Float(Depth - 1) + ")";
	case 3: return "(" + Float(Depth - 1) + " / " + Float(Depth - 1) + ")";
	case 4: return Pick({"min(", "max("}) + Float(Depth - 1) + ", " + Float(Depth - 1) + ")";
	case 5: return Pick({"abs(", "floor(", "frac(", "saturate(", "ceil(", "trunc(", "round("}) + Float(Depth - 1) + ")";
	case 6: return "(" + Bool(Depth - 1) + " ? " + Float(Depth - 1) + " : " + Float(Depth - 1) + ")";
	case 7: return "(float)" + Int(Depth - 1);
	case 8: return "(float)" + Uint(Depth - 1);
	case 9: return "dot(" + Vector(Depth - 1) + ", " + Vector(Depth - 1) + ")";
	case 10: return "fa[" + Uint(Depth - 1) + " % 5]";
	case 11: return "Weights[" + Uint(Depth - 1) + " % 7]";
	case 12: return "Table[" + Uint(Depth - 1) + " % 8]." + Pick({"x", "y", "w"});
	default: return "lerp(" + Float(Depth - 1) + ", " + Float(Depth - 1) + ", " + Float(Depth - 1) + ")";
	}
}

std::string FProgramGenerator::Int(int Depth)
{
	if (Depth <= 0 || Chance(20))
	{
		return Pick({"i0", "i1", "i2", "n", "w0.x", "w0.y", "UniformInt", "3", "-7", "1"});
	}
	switch (Below(12))
	{
	case 0: return "(" + Int(Depth - 1) + " + " + Int(Depth - 1) + ")";
	case 1: return "(" + Int(Depth - 1) + " - " + Int(Depth - 1) + ")";
	case 2: return "(" + Int(Depth - 1) + " * " + Int(Depth - 1) + ")";
	case 3: return "(" + Int(Depth - 1) + " / " + Pick({"3", "7", "-5"}) + ")";
	case 4: return "(" + Int(Depth - 1) + " % " + Pick({"5", "9", "-4"}) + ")";
	case 5: return "(" + Int(Depth - 1) + Pick({" & ", " | ", " ^ "}) + Int(Depth - 1) + ")";
	case 6: return "(" + Int(Depth - 1) + Pick({" << ", " >> "}) + "(" + Int(Depth - 1) + " & 7))";
	case 7: return Pick({"min(", "max("}) + Int(Depth - 1) + ", " + Int(Depth - 1) + ")";
	case 8: return "(" + Bool(Depth - 1) + " ? " + Int(Depth - 1) + " : " + Int(Depth - 1) + ")";
	case 9: return "(int)" + Float(Depth - 1);
	case 10: return "ia[" + Uint(Depth - 1) + " % 4]";
	default: return Pick({"abs(", "-(", "~("}) + Int(Depth - 1) + ")";
	}
}

std::string FProgramGenerator::Uint(int Depth)
{
	if (Depth <= 0 || Chance(20))
	{
		return Pick({"u0", "u1", "Id.x", "Id.y", "(uint)n", "(uint)UniformInt", "5u", "17u"});
	}
	switch (Below(7))
	{
	case 0: return "(" + Uint(Depth - 1) + " + " + Uint(Depth - 1) + ")";
	case 1: return "(" + Uint(Depth - 1) + " * " + Uint(Depth - 1) + ")";
	case 2: return "(" + Uint(Depth - 1) + " / " + Pick({"3u", "7u"}) + ")";
	case 3: return "(" + Uint(Depth - 1) + Pick({" & ", " | ", " ^ "}) + Uint(Depth - 1) + ")";
	case 4: return "(" + Uint(Depth - 1) + " >> (" + Uint(Depth - 1) + " & 15u))";
	case 5: return "(uint)" + Int(Depth - 1);
	default: return Pick({"countbits(", "reversebits(", "firstbithigh("}) + Uint(Depth - 1) + ")";
	}
}

std::string FProgramGenerator::Bool(int Depth)
{
	if (Depth <= 0 || Chance(10))
	{
		return Pick({"b0", "b1", "(n > 2)", "(x < 0.5)", "(UniformInt > 1)", "((Id.x & 1u) == 0u)"});
	}
	switch (Below(7))
	{
	case 0: return "(" + Float(Depth - 1) + Pick({" < ", " > ", " <= ", " >= ", " == ", " != "}) + Float(Depth - 1) + ")";
	case 1: return "(" + Int(Depth - 1) + Pick({" < ", " > ", " <= ", " >= ", " == ", " != "}) + Int(Depth - 1) + ")";
	case 2: return "(" + Uint(Depth - 1) + Pick({" < ", " > ", " <= ", " >= ", " == ", " != "}) + Uint(Depth - 1) + ")";
	case 3: return "(" + Bool(Depth - 1) + Pick({" && ", " || "}) + Bool(Depth - 1) + ")";
	case 4: return "!" + Bool(Depth - 1);
	case 5: return Pick({"any(", "all("}) + Vector(Depth - 1) + " > " + Vector(Depth - 1) + ")";
	default: return "((" + Uint(Depth - 1) + " & 3u) == 1u)";
	}
}

std::string FProgramGenerator::Vector(int Depth)
{
	if (Depth <= 0 || Chance(25))
	{
		return Pick({"v0", "v1", "Input", "v0.wzyx", "v1.xxyz", "Table[2]"});
	}
	switch (Below(8))
	{
	case 0: return "(" + Vector(Depth - 1) + Pick({" + ", " - ", " * "}) + Vector(Depth - 1) + ")";
	case 1: return "(" + Vector(Depth - 1) + " * " + Float(Depth - 1) + ")";
	case 2: return "float4(" + Float(Depth - 1) + ", " + Float(Depth - 1) + ", " + Float(Depth - 1) + ", " + Float(Depth - 1) + ")";
	case 3: return Pick({"min(", "max("}) + Vector(Depth - 1) + ", " + Vector(Depth - 1) + ")";
	case 4: return "(" + Bool(Depth - 1) + " ? " + Vector(Depth - 1) + " : " + Vector(Depth - 1) + ")";
	case 5: return "mul(" + Vector(Depth - 1) + ", Matrix)";
	case 6: return "mul(Matrix, " + Vector(Depth - 1) + ")";
	default: return "Table[" + Uint(Depth - 1) + " % 8]";
	}
}

// clang-format on

std::string FProgramGenerator::Loop(int Depth)
{
	const std::string Name = "k" + std::to_string(NumNames++);
	const std::string Limit = Pick({"4", "UniformInt", "(n & 7)", "(i1 & 3)", "(int)(Id.x % 5u)"});
	++LoopDepth;
	LoopNames.push_back(Name);
	const int OuterSwitch = std::exchange(SwitchDepth, 0);
	++IndentLevel;
	const std::string Body = Statements(Depth - 1, 2 + Below(3));
	--IndentLevel;
	SwitchDepth = OuterSwitch;
	LoopNames.pop_back();
	--LoopDepth;
	switch (Below(3))
	{
	case 0:
		return Indent() + "int " + Name + " = 0;\n" + Indent() + "while (" + Name + " < 6 && " + Bool(2) + ")\n" +
			   Indent() + "{\n" + Indent() + "\t++" + Name + ";\n" + Body + Indent() + "}\n";
	case 1:
		return Indent() + "int " + Name + " = 0;\n" + Indent() + "do\n" + Indent() + "{\n" + Indent() + "\t++" + Name +
			   ";\n" + Body + Indent() + "} while (" + Name + " < " + Limit + ");\n";
	default:
		return Indent() + "for (int " + Name + " = 0; " + Name + " < " + Limit + "; ++" + Name + ")\n" + Indent() +
			   "{\n" + Indent() + "\ti2 += " + Name + ";\n" + Body + Indent() + "}\n";
	}
}

std::string FProgramGenerator::Switch(int Depth)
{
	std::string Text = Indent() + "switch (" + Int(2) + " & 3)\n" + Indent() + "{\n";
	++SwitchDepth;
	const int Default = Below(4);
	for (int Case = 0; Case < 4; ++Case)
	{
		Text += Indent() + (Case == Default ? "default:\n" : "case " + std::to_string(Case) + ":\n");
		if (Chance(20) && Case < 3)
		{
			continue; // two labels, one body
		}
		++IndentLevel;
		Text += Statements(Depth - 1, 1 + Below(2));
		// Falling into the next case is not HLSL of the engine's compilers, but the front end accepts it.
		Text += Case == 3 || Chance(70) ? Indent() + "break;\n" : "";
		--IndentLevel;
	}
	--SwitchDepth;
	return Text + Indent() + "}\n";
}

std::string FProgramGenerator::Statement(int Depth)
{
	switch (Below(Depth > 0 ? 20 : 11))
	{
	case 0:
		return Indent() + Pick({"f0", "f1", "f2"}) + Pick({" = ", " += ", " *= "}) + Float(2) + ";\n";
	case 1:
		return Indent() + Pick({"i0", "i1", "i2"}) + Pick({" = ", " += ", " ^= "}) + Int(2) + ";\n";
	case 2:
		return Indent() + Pick({"u0", "u1"}) + Pick({" = ", " += "}) + Uint(2) + ";\n";
	case 3:
		return Indent() + Pick({"b0", "b1"}) + " = " + Bool(2) + ";\n";
	case 4:
		return Indent() + Pick({"v0", "v1"}) + Pick({" = ", " += "}) + Vector(2) + ";\n";
	case 5:
		return Indent() + Pick({"v0.xy", "v1.zw", "v0.yw"}) + " = " + Vector(2) + Pick({".xy;\n", ".wz;\n"});
	case 6:
		return Indent() + "fa[" + Uint(2) + " % 5] = " + Float(2) + ";\n";
	case 7:
		return Indent() + "ia[" + Uint(2) + " % 4] = " + Int(2) + ";\n";
	case 8:
		return Indent() + "w0." + Pick({"x", "y", "z"}) + " = " + Int(2) + ";\n";
	case 9:
		return Indent() + "Log[Slot] = Log[Slot] * 3 + " + Int(2) + ";\n";
	case 10:
		if (NumFunctions > 0 && !bInHelper && Depth > 0)
		{
			return Indent() + "f1 += Function" + std::to_string(Below(NumFunctions)) + "(Id, Slot, Input, " + Int(1) +
				   ", i2).y;\n";
		}
		return Indent() + "f2 = " + Float(2) + ";\n";
	case 11:
	case 12:
	case 13:
	{
		std::string Text = Indent() + "if (" + Bool(2) + ")\n" + Indent() + "{\n";
		++IndentLevel;
		Text += Statements(Depth - 1, 1 + Below(3));
		--IndentLevel;
		Text += Indent() + "}\n";
		if (Chance(50))
		{
			Text += Indent() + "else\n" + Indent() + "{\n";
			++IndentLevel;
			Text += Statements(Depth - 1, 1 + Below(2));
			--IndentLevel;
			Text += Indent() + "}\n";
		}
		return Text;
	}
	case 14:
	case 15:
	case 16:
		return LoopDepth < 2 ? Loop(Depth) : Statement(0);
	case 17:
		return Switch(Depth);
	case 18:
		if (LoopDepth > 0)
		{
			// break leaves a switch, not the loop around it; continue always means the loop.
			const std::string Jump = SwitchDepth > 0 || Chance(50) ? "continue;\n" : "break;\n";
			// Conditions that are the same in all lanes matter most where some lanes already wait elsewhere.
			const std::string Condition = Chance(40) ? LoopNames.back() + Pick({" == 1", " == 2", " > 2"}) : Bool(2);
			return Indent() + "if (" + Condition + ")\n" + Indent() + "{\n" + Indent() + "\t" + Jump + Indent() + "}\n";
		}
		return Statement(0);
	default:
		return Indent() + "if (" + Bool(2) + ")\n" + Indent() + "{\n" + Indent() + "\tOther = i1;\n" + Indent() +
			   "\treturn " + Vector(2) + ";\n" + Indent() + "}\n";
	}
}

std::string FProgramGenerator::Statements(int Depth, int Count)
{
	std::string Text;
	for (int i = 0; i < Count; ++i)
	{
		Text += Statement(Depth);
	}
	return Text;
}

std::string FProgramGenerator::Function(int Index)
{
	LoopDepth = SwitchDepth = 0;
	IndentLevel = 1;
	bInHelper = Index < 1;
	const std::string Head =
		"float4 Function" + std::to_string(Index) +
		"(uint2 Id, uint Slot, float4 Input, int n, inout int Other)\n{\n"
		"\tfloat x = Input.x;\n\tfloat f0 = Input.y;\n\tfloat f1 = 1.0;\n\tfloat f2 = UniformFloat;\n"
		"\tint i0 = Other;\n\tint i1 = n + 3;\n\tint i2 = 0;\n\tuint u0 = Id.x * 3u;\n\tuint u1 = 9u;\n"
		"\tbool b0 = Input.w > 0.0;\n\tbool b1 = UniformInt > 2;\n"
		"\tfloat4 v0 = Input;\n\tfloat4 v1 = float4(1.0, 2.0, UniformFloat, x);\n\tint3 w0 = int3(n, UniformInt, 5);\n"
		"\tfloat fa[5] = { 0.0, x, 2.0, UniformFloat, 4.0 };\n\tint ia[4] = { 1, 2, n, UniformInt };\n";
	const std::string Body = Statements(bInHelper ? 1 : 3, bInHelper ? 3 : 5);
	return Head + Body +
		   "\tOther = i0 + i1 * 3 + i2 * 7 + w0.x + w0.y + w0.z + ia[0] + ia[3] + (int)u0;\n"
		   "\treturn v0 + v1 + float4(f0, f1, f2, fa[0] + fa[4] + (b0 ? 1.0 : 0.0) + (b1 ? 2.0 : 0.0) + (float)(u1 & "
		   "255u));\n}\n\n";
}

std::string FProgramGenerator::Make(int Count)
{
	std::string Text =
		"StructuredBuffer<float4> Data;\nRWStructuredBuffer<float4> OutFloat;\nRWStructuredBuffer<int> OutInt;\n"
		"RWStructuredBuffer<int> Log;\nint UniformInt;\nfloat UniformFloat;\nint Width;\nfloat4 Table[8];\nfloat4x4 "
		"Matrix;\n"
		"static const float Weights[7] = { 0.0045, 0.054, 0.24, 0.4, 0.24, 0.054, 0.0045 };\n\n";
	NumFunctions = 0;
	for (int i = 0; i < Count; ++i)
	{
		Text += Function(i);
		++NumFunctions;
	}
	Text += "[numthreads(8, 8, 1)]\nvoid MainCS(uint2 Id : SV_DispatchThreadID)\n{\n\tuint Thread = Id.y * (uint)Width "
			"+ Id.x;\n\tint Other;\n";
	for (int i = 0; i < Count; ++i)
	{
		const std::string Slot = "Thread * " + std::to_string(Count) + "u + " + std::to_string(i) + "u";
		Text += "\tOther = (int)Id.x;\n\tOutFloat[" + Slot + "] = Function" + std::to_string(i) + "(Id, " + Slot +
				", Data[Thread], (int)((Id.x * 7u + Id.y * 3u) % 11u) - 2, Other);\n"
				"\tOutInt[" +
				Slot + "] = Other;\n";
	}
	return Text + "}\n";
}

} // namespace Drydock::Test
