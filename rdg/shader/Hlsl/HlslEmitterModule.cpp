// Writes functions, one for each set of resources that they are called with, and their calls.
#include "HlslEmitterImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr int EmitMaxDepth = 2000;        // values and statements inside each other
constexpr size_t EmitMaxInstances = 4096; // functions, each with another set of resources

bool IsEmitOut(const FVariable& Parameter)
{
	return Parameter.Storage == EStorage::This ? Parameter.bWritten : (Parameter.Modifiers & ModifierOut) != 0;
}

bool IsEmitIn(const FVariable& Parameter)
{
	return Parameter.Storage == EStorage::This || (Parameter.Modifiers & ModifierOut) == 0 ||
		   (Parameter.Modifiers & ModifierIn) != 0;
}

} // namespace

void FEmitter::Deeper(const FPlace& Place, const std::function<void()>& Work)
{
	if (++Depth > EmitMaxDepth)
	{
		Fail(Place, "more than " + std::to_string(EmitMaxDepth) +
						" expressions and statements inside each other; put parts into variables or functions");
	}
	Work();
	--Depth;
}

uint32_t FEmitter::Op(uint16_t Opcode, uint32_t Type, const FWords& Operands)
{
	const uint32_t Id = Module.NewId();
	FWords Words = {Type, Id};
	Words.insert(Words.end(), Operands.begin(), Operands.end());
	Do(Opcode, Words);
	return Id;
}

void FEmitter::Do(uint16_t Opcode, const FWords& Operands)
{
	FBody& Body = Frame->Body;
	if (!Body.bOpen)
	{
		return;
	}
	if (Current.Line > 0 && (Body.File != Current.File || Body.Line != Current.Line) && Opcode != OpLabel)
	{
		Body.File = Current.File;
		Body.Line = Current.Line;
		const std::string File = Current.File < Program.Files.size() ? Program.Files[Current.File] : std::string();
		AddWords(Body.Code, OpLine, {Module.String(File), uint32_t(Current.Line), 0});
	}
	AddWords(Body.Code, Opcode, Operands);
}

uint32_t FEmitter::Ext(uint32_t Number, uint32_t Type, const FWords& Operands)
{
	FWords Words = {Module.GetExtended(), Number};
	Words.insert(Words.end(), Operands.begin(), Operands.end());
	return Op(OpExtInst, Type, Words);
}

uint32_t FEmitter::Temporary(uint32_t Type, std::string_view Name)
{
	const uint32_t Id = Module.NewId();
	AddWords(Frame->Body.Variables, OpVariable, {Module.Pointer(StorageFunction, Type), Id, StorageFunction});
	if (!Name.empty())
	{
		Module.Name(Id, Name);
	}
	return Id;
}

/** Begins a function; the ids of its parameters. */
FWords FEmitter::Begin(FFrame& New, uint32_t Id, uint32_t Result, const FWords& Parameters, std::string_view Name)
{
	FWords Type = {Result};
	Type.insert(Type.end(), Parameters.begin(), Parameters.end());
	AddWords(New.Body.Head, OpFunction, {Result, Id, 0, Module.Intern(OpTypeFunction, Type)});
	FWords Ids;
	for (const uint32_t Parameter : Parameters)
	{
		Ids.push_back(Module.NewId());
		AddWords(New.Body.Head, OpFunctionParameter, {Parameter, Ids.back()});
	}
	AddWords(New.Body.Head, OpLabel, {Module.NewId()});
	Module.Name(Id, Name);
	Frame = &New;
	return Ids;
}

FInstance& FEmitter::GetInstance(const FFunction& Function, const std::vector<FObjects>& Arguments)
{
	FWords Key;
	for (const FObjects& Argument : Arguments)
	{
		for (const FObjectSet& Set : Argument)
		{
			Key.push_back(uint32_t(Set.Leaves.size()));
			for (const FLeaf* const Leaf : Set.Leaves)
			{
				Key.push_back(Leaf->Number);
			}
		}
	}
	FInstance*& Instance = Instances[{&Function, Key}];
	if (!Instance)
	{
		if (InstancePool.size() >= EmitMaxInstances)
		{
			Fail(Function.Place, "functions are called with more than " + std::to_string(EmitMaxInstances) +
									 " sets of resources; pass fewer resources as arguments");
		}
		Instance = &InstancePool.emplace_back();
		Instance->Id = Module.NewId();
		Instance->Results.resize(CountObjects(Function.Result));
		FFrame* const Outer = Frame;
		const FPlace Place = Current;
		WriteFunction(Function, *Instance, Arguments);
		Frame = Outer;
		Current = Place;
	}
	return *Instance;
}

void FEmitter::WriteFunction(const FFunction& Function, FInstance& Instance, const std::vector<FObjects>& Arguments)
{
	FWords Parameters;
	for (size_t i = 0; i < Function.Parameters.size(); ++i)
	{
		const FType* const Type = Function.Parameters[i]->Type;
		if (CountScalars(Type) > 0)
		{
			Parameters.push_back(Module.Pointer(StorageFunction, TypeOf(Type)));
		}
		for (const FObjectSet& Set : Arguments[i])
		{
			if (Set.Leaves.size() > 1)
			{
				Parameters.push_back(Module.Pointer(StorageFunction, Module.Uint()));
			}
		}
	}
	FFrame New;
	New.Function = &Function;
	New.Instance = &Instance;
	const uint32_t Result = CountScalars(Function.Result) ? TypeOf(Function.Result) : Module.Intern(OpTypeVoid, {});
	const bool bEntry = &Function == Program.Entry;
	const FWords Ids = Begin(New, Instance.Id, Result, Parameters, (bEntry ? "@" : "") + Function.Name + "(");
	size_t Next = 0;
	for (size_t i = 0; i < Function.Parameters.size(); ++i)
	{
		const FVariable* const Parameter = Function.Parameters[i];
		if (CountScalars(Parameter->Type) > 0)
		{
			New.Locals[Parameter] = Ids[Next];
			Module.Name(Ids[Next++], Parameter->Name);
		}
		for (const FObjectSet& Set : Arguments[i])
		{
			New.Slots[Parameter].push_back({Set.Leaves, Set.Leaves.size() > 1 ? Ids[Next++] : 0});
		}
	}
	SetPlace(Function.Place);
	if (Function.Body)
	{
		FindObjects(Function);
		Statement(*Function.Body);
	}
	if (New.Body.bOpen)
	{
		CountScalars(Function.Result) ? End(OpReturnValue, {Module.Null(Result)}) : End(OpReturn);
	}
	Module.AddFunction(New.Body);
}

void FEmitter::FindCallee(const FValue& Node, bool bEmit, FInstance*& Called)
{
	if (bEmit)
	{
		Call(Node, &Called);
		return;
	}
	std::vector<FObjects> Arguments;
	for (const FValue* const Operand : Node.Operands)
	{
		Arguments.push_back(HasObject(Operand->Type) ? Objects(*Operand, false) : FObjects());
	}
	Called = &GetInstance(*Node.Function, Arguments);
}

/** Arguments go into variables of the caller, and come back from there where the parameter gives something back. */
uint32_t FEmitter::Call(const FValue& Node, FInstance** Called)
{
	const FFunction& Function = *Node.Function;
	std::vector<FObjects> Arguments(Function.Parameters.size());
	struct FBack
	{
		FTarget Target;
		const FType* Type; // of the target
		FPart Part;
	};
	std::vector<FBack> Back;
	FWords Ids;
	for (size_t i = 0; i < Function.Parameters.size(); ++i)
	{
		const FVariable& Parameter = *Function.Parameters[i];
		const FValue& Argument = *Node.Operands.at(i);
		uint32_t Id = 0;
		if (IsEmitOut(Parameter) && CountScalars(Parameter.Type) > 0)
		{
			Arguments[i] = HasObject(Parameter.Type) ? Objects(Argument) : FObjects();
			Back.push_back(
				{Place(Argument), Argument.Type, {Temporary(TypeOf(Parameter.Type), "param"), Parameter.Type}});
			Ids.push_back(Back.back().Part.Id);
			Id = IsEmitIn(Parameter) ? Convert(Load(Back.back().Target), Argument.Type, Parameter.Type) : 0;
		}
		else
		{
			Id = Both(Argument, Arguments[i]);
			if (CountScalars(Parameter.Type) > 0)
			{
				Ids.push_back(Temporary(TypeOf(Parameter.Type), "param"));
			}
		}
		if (Id)
		{
			Do(OpStore, {Ids.back(), Id});
		}
		for (const FObjectSet& Set : Arguments[i])
		{
			if (Set.Leaves.size() > 1)
			{
				Ids.push_back(Temporary(Module.Uint(), "param"));
				Do(OpStore, {Ids.back(), Set.Number});
			}
		}
	}
	FInstance& Instance = GetInstance(Function, Arguments);
	if (Called)
	{
		*Called = &Instance;
	}
	const bool bValue = CountScalars(Function.Result) > 0;
	Ids.insert(Ids.begin(), Instance.Id);
	LastCall = Op(OpFunctionCall, bValue ? TypeOf(Function.Result) : Module.Intern(OpTypeVoid, {}), Ids);
	LastCall = bValue ? LastCall : 0;
	const uint32_t Result = LastCall;
	for (const FBack& Each : Back)
	{
		const uint32_t Id = Op(OpLoad, TypeOf(Each.Part.Type), {Each.Part.Id});
		Store(Each.Target, Convert(Id, Each.Part.Type, Each.Type));
	}
	LastCall = Result;
	return Result;
}

/** Runs in the entry point before all else. */
void FEmitter::WriteStatics()
{
	for (const FBuffer* const Buffer : Program.Buffers)
	{
		for (const FVariable* const Member : Buffer->Members)
		{
			if (Member->bWritten && CountScalars(Member->Type) > 0) // a copy for each thread
			{
				Store(VariablePlace(*Member), Load(BufferPlace(*Member)));
			}
		}
	}
	for (const FVariable* const Variable : Program.Statics)
	{
		const bool bKnown = Variable->Constant && !Variable->bWritten;
		if (Variable->Storage == EStorage::Static && CountScalars(Variable->Type) > 0 && !bKnown)
		{
			SetPlace(Variable->Place);
			const uint32_t Id =
				Variable->Initializer ? Value(*Variable->Initializer) : Module.Null(TypeOf(Variable->Type));
			Store(VariablePlace(*Variable), Id);
		}
	}
}

FWords FEmitter::Run()
{
	MakeLeaves();
	const uint32_t Entry = WriteEntry();
	if (bWaves)
	{
		Module.Capability(CapabilityGroupNonUniform);
	}
	const uint32_t Model = Program.Stage == EStage::Vertex  ? ExecutionModelVertex
						   : Program.Stage == EStage::Pixel ? ExecutionModelFragment
															: ExecutionModelCompute;
	return Module.Finish(Model, Entry, Program.Entry->Name, Interface, Modes, bWaves);
}

FEmission Emit(const FProgram& Program)
{
	FEmission Emission;
	FEmitter Emitter(Program);
	try
	{
		Emission.Words = Emitter.Run();
	}
	catch (const FModuleFault&)
	{
		Emission.Error = "more than 65000 values make one array, struct or switch here; split it";
		Emission.Place = Emitter.GetPlace();
	}
	catch (const FEmitFault& Fault)
	{
		Emission.Error = Fault.Message;
		Emission.Place = Fault.Place;
	}
	return Emission;
}

} // namespace Drydock::Hlsl
